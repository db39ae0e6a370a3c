// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QString>

#include <chrono>
#include <cstdint>

class QWidget;

namespace spherewalk::ui {

/// Returns a duration in the user's language: "45 s", "18 min", "2 h 17 min".
QString durationText(std::chrono::duration<double> duration);

/// Returns a byte count with a unit in powers of ten: "512 bytes", "4.2 MB".
QString bytesText(std::uint64_t bytes);

/// State of a station or of its photo. A decision of a person goes before the result of the checks.
enum class Standing { Missing, Taken, Accepted, Doubtful, Failed, Rejected };

/// Returns the state as one translated word.
QString standingText(Standing standing);

/// Returns a sign for the state that needs no colour.
QString standingSign(Standing standing);

/// Tells assistive tools what a widget is that draws itself, and its name.
void announceAs(QWidget& widget, QAccessible::Role role, const QString& name);

} // namespace spherewalk::ui
