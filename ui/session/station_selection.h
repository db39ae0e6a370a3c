// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <cstdint>
#include <optional>

namespace spherewalk::ui {

/// The station that all views of a survey show as the current one, so that a click in one is seen in all.
class StationSelection : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    std::optional<std::int64_t> current() const { return m_current; }

    void setCurrent(std::optional<std::int64_t> station) {
        if (station != m_current) {
            m_current = station;
            emit currentChanged(station);
        }
    }

  signals:
    void currentChanged(std::optional<std::int64_t> station);

  private:
    std::optional<std::int64_t> m_current;
};

} // namespace spherewalk::ui
