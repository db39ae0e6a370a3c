// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/standing.h"

#include <QCoreApplication>

namespace spherewalk::ui {

QString standingText(Standing standing) {
    switch (standing) {
    case Standing::Missing:
        return QCoreApplication::translate("Standing", "missing");
    case Standing::Taken:
        return QCoreApplication::translate("Standing", "taken");
    case Standing::Accepted:
        return QCoreApplication::translate("Standing", "accepted");
    case Standing::Doubtful:
        return QCoreApplication::translate("Standing", "doubtful");
    case Standing::Failed:
        return QCoreApplication::translate("Standing", "failed");
    case Standing::Rejected:
        return QCoreApplication::translate("Standing", "rejected");
    }
    return {};
}

QString standingSign(Standing standing) {
    switch (standing) {
    case Standing::Missing:
        return QStringLiteral("○");
    case Standing::Taken:
        return QStringLiteral("●");
    case Standing::Accepted:
        return QStringLiteral("✓");
    case Standing::Doubtful:
        return QStringLiteral("▲");
    case Standing::Failed:
        return QStringLiteral("⊠");
    case Standing::Rejected:
        return QStringLiteral("⊘");
    }
    return {};
}

} // namespace spherewalk::ui
