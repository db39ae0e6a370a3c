// SPDX-License-Identifier: GPL-3.0-or-later
// What a CaptureDesk is doing, in the window's language, for all who show it: the page and the phone.
#pragma once

#include "ui/capture/capture_desk.h"

#include <QString>

namespace spherewalk::ui {

/// Returns what happens, to be read before the name of the station: "Bring the camera to".
QString stateWords(const CaptureDesk& desk);

/// Returns what the key does now: "Shoot".
QString keyWords(const CaptureDesk& desk);

/// Returns what there is to say of the latest shot, or what went wrong; empty if there is nothing to say.
Told resultWords(const CaptureDesk& desk);

/// Returns the warning that goes with the practice camera.
QString practiceWords();

} // namespace spherewalk::ui
