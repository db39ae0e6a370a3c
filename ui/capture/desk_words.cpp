// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/desk_words.h"

#include <QCoreApplication>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

struct CaptureWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::CaptureWords)
};

} // namespace

QString stateWords(const CaptureDesk& desk) {
    if (desk.isComplete()) {
        return CaptureWords::tr("Every station has its photo.");
    }
    switch (desk.state()) {
    case State::NoCamera:
        return CaptureWords::tr("Connect a camera, or try the practice camera.");
    case State::Connecting:
        return CaptureWords::tr("Connecting...");
    case State::Ready:
        return desk.isByHand() ? CaptureWords::tr("By hand: walk through the room and shoot.")
                               : CaptureWords::tr("The next station:");
    case State::Preparing:
        return CaptureWords::tr("Preparing the camera...");
    case State::AtStation:
        return desk.isByHand() ? CaptureWords::tr("Stand where you like and shoot")
                               : CaptureWords::tr("Bring the camera to");
    case State::AskAgain:
        return CaptureWords::tr("No picture was taken at");
    case State::Hiding:
        return CaptureWords::tr("Hide! The picture is taken at");
    case State::Shooting:
        return CaptureWords::tr("Taking the picture at");
    }
    return {};
}

QString keyWords(const CaptureDesk& desk) {
    switch (desk.state()) {
    case State::AtStation:
        return CaptureWords::tr("Shoot");
    case State::AskAgain:
        return CaptureWords::tr("Try again");
    case State::Hiding:
        return CaptureWords::tr("%1 ... (press to wait)").arg(desk.countdown());
    case State::Preparing:
    case State::Shooting:
        return CaptureWords::tr("Please wait");
    default:
        return desk.stationsLeft() == desk.stations() && !(desk.isByHand() && desk.stations() > 0)
                   ? CaptureWords::tr("Start")
                   : CaptureWords::tr("Go on");
    }
}

Told resultWords(const CaptureDesk& desk) {
    const bool isStored =
        desk.verdict() == survey::Quality::Good && desk.told().isEmpty() && !desk.isComplete();
    return isStored ? Told(CaptureWords::tr("The photo is stored.")) : desk.told();
}

QString practiceWords() {
    return CaptureWords::tr("PRACTICE: photos of a room that exists only in the program");
}

} // namespace spherewalk::ui
