// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/words.h"

#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QLocale>
#include <QVariant>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Duration", text);
}

} // namespace

QString durationText(std::chrono::duration<double> duration) {
    constexpr qint64 kMinute = 60;
    constexpr qint64 kHour = 3600;
    const auto seconds = static_cast<qint64>(std::llround(std::max(0.0, duration.count())));
    if (seconds < 2 * kMinute) {
        return words(QT_TRANSLATE_NOOP("Duration", "%1 s")).arg(seconds);
    }
    const qint64 minutes = (seconds + kMinute / 2) / kMinute;
    return seconds < kHour
               ? words(QT_TRANSLATE_NOOP("Duration", "%1 min")).arg(minutes)
               : words(QT_TRANSLATE_NOOP("Duration", "%1 h %2 min")).arg(minutes / 60).arg(minutes % 60);
}

QString bytesText(std::uint64_t bytes) {
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

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

namespace {

constexpr const char* kRole = "announcedRole";

QAccessibleInterface* announced(const QString& /*className*/, QObject* object) {
    auto* widget = qobject_cast<QWidget*>(object);
    const QVariant role = widget != nullptr ? widget->property(kRole) : QVariant();
    return role.isValid() ? new QAccessibleWidget(widget, static_cast<QAccessible::Role>(role.toInt()))
                          : nullptr;
}

} // namespace

void announceAs(QWidget& widget, QAccessible::Role role, const QString& name) {
    widget.setProperty(kRole, static_cast<int>(role));
    QAccessible::installFactory(&announced); // once, however often
    widget.setAccessibleName(name);          // last: what is announced is kept from here on
}

} // namespace spherewalk::ui
