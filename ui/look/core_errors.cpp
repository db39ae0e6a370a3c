// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/core_words.h"

#include <QtGlobal>

namespace spherewalk::ui {

namespace {

constexpr const char* kErrors[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not reach the camera at %1 within %2; press its power button in case it sleeps, "
                      "and check that this computer is on the camera's WiFi."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "No answer from the camera at %1 within %2; press its "
                                                   "power button in case it sleeps, and check the WiFi."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not reach the camera at %1 (%2); check that it is switched on, that no USB data "
                      "cable is plugged in, and that this computer is on its WiFi."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The connection to the camera at %1 broke (%2); move "
                                                   "closer to the camera, check the WiFi, and try again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "What answers at %1 does not speak HTTP; check the address of the camera."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "What answers at %1 sent more than a camera would; check the address."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "What answers at http://%1 is not a spherical camera (%2); check that this computer is on the "
        "camera's WiFi and not also on another network with the same addresses, and check the address."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The download from the camera at %1 stood still for %2; move closer to the camera and try again."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera's address \"%1\" cannot be used; write it like 192.168.1.1 or http://127.0.0.1:8080."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera named a photo by \"%1\", which is not a usable URL; update its firmware."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera names photos as API level 1 does (\"%1\"); such cameras cannot be used yet."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera at %1 sent %2; switch it off and on if this persists."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "an empty answer"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "an answer that is not valid JSON"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera at %1 sent JSON that is not an object; update its firmware."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera at %1 has sent no picture of its preview for %2 s; check the WiFi, press "
                      "the camera's button in case it sleeps, and start the preview again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "A plug-in runs on the camera; end it by the camera's mode button, then resume."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera's battery is at %1; charge it before going on."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera's battery is at %1; charge it soon."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera has room for only %1 more photos."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The survey's disk has room for about %1 of the %2 photos that are still to be taken; "
                      "make space before you go on."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera's storage is full; back its photos up, free some space, and resume."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Another camera answers (serial number %1 instead of %2); check the WiFi, or connect anew."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Another camera answers now (serial number %1); whether the camera %2 has taken this "
                      "photo must be looked up on it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera %1 speaks neither API level 1 nor 2; use another."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The photo %1 has %2 x %3 pixels, but a spherical photo is twice as wide as high and "
                      "at least %4 wide; set the camera to full-size stitched photos."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera has given the name %1 to another photo, so that this one is gone; take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The photo %1 is not a JPEG; set the camera to JPEG and take it again."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera stays busy (\"%1\"); end what it is doing, or switch it off and on, then resume."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera says that it is still taking the photo long after it must have been done; "
                      "switch it off and on, then resume."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera stays busy or gives no steady answer about "
                                                   "its files; switch it off and on, then resume."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera has taken no photo; it can be taken again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera says that it has taken the photo, but has no new file: its files were "
                      "deleted, or their names begin anew."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera started a session without a name; switch it off and on."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera stays at API level 1 although it offers level 2; switch it off and on."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera takes no photos %1 pixels wide, but %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Change the survey's capture profile."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera does not offer the white balance %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera does not offer the %1 %2; the nearest are %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The camera stays in the mode \"%1\"; set it to still pictures by its mode button."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera does not take spherical JPEGs twice as wide as high; set it to stitched JPEG photos."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The camera could not be told that it may sleep again; switch it off and on if it is not used soon."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Where the photos were taken is not known yet."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Of the last photo: %1"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The downloaded photo changed on the disk before it was recorded; the next run downloads it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The photo of %1 is not known to be its own any more; take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera refused to %1 (\"%2\"): %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "take the photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "list its files"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "describe itself"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "show its preview"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "speak API level 2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "start a session"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "tell its settings"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "change its settings"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "tell its state"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera refused to %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "this camera cannot do it; update its firmware or use another camera"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "set the camera to still pictures, end its plug-in or preview, close the telephone's "
                      "application, and try again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "the camera does not allow this value in its present mode"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "the file is damaged on the camera; take the photo again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "the camera is switching off; switch it on and resume"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "wait a moment and try again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "switch the camera off and on, then resume"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "the shot was cancelled at the camera; take it again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "check that nobody has deleted the file from the camera"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "the camera has ended the session; switch it off and on, and close the telephone's application"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "close the other program or telephone that uses the camera; if none does, wait three minutes"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "the camera's storage is full; back its photos up and free some space"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "it asks for a user name and a password (client mode), and was given none or wrong "
                      "ones; give the right ones, or use the camera's own WiFi"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "update the camera's firmware; if it stays so, report it"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The photo %1 is not usable: %2; %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "fetch it from the camera again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "it has %1 bytes instead of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "it is not a JPEG"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "its end is missing"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "its bytes are not those that were recorded (the SHA-256 differs)"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "it is not spherical, its %1 pixels are not twice as wide as high"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "take or export it as a whole stitched sphere"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "it is only %1 pixels wide, as a preview is; at least %2 are needed"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The photo %1 is in the survey already, as %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The picture %1 has %2 x %3 pixels, not the camera's %4 x %5."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 is in the survey already, as %2 at %3, %4 m from the place in the file."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 photos stand outside of the room's outline; check the outline and the positions."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read the positions %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: there is no such file or folder."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not write %1: there is no such file or folder."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: %2; check the permissions."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not write %1: %2; check the permissions."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not write %1: the disk is full; free some space and try again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not write %1: it exists already."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not write %1; is the disk full?"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not write %1 %2: it exists already; choose another name, or remove it first."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: it is not a file."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: it ends too early; copy the file again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: it has %2, more than the %3 that such a file may have."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: it is not valid JSON."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: it is neither a PNG nor a JPEG."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not read %1: the PNG is damaged, copy it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not make the folder %1: %2."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Could not make a temporary folder %1: %2; set TMPDIR to a folder that can be written."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Stopped on request; what was complete is kept."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 is not a survey: %2; give a folder that Spherewalk has made."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "There is no survey %1; check the path."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not open the survey %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The survey's database %1 is empty."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The survey's database %1 is damaged: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Restore it from a copy; the photos beside it are not affected."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The survey %1 was written by a newer Spherewalk (format %2, this one knows up to %3); "
                      "update Spherewalk to open it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not create the survey %1: there is something by "
                                                   "that name already; open it, or choose another name."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not create the survey %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not create the folder %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not change the survey %1: it is open for reading only."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The survey %1 is being written by another program%2; close it there, or open it here for reading."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The survey %1 is being written by another program; close it there, or open it here for reading."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Could not open the survey %1 for writing: %2; check the permissions, or open it for reading."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not lock the survey %1 for writing: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not replace the plan of the survey %1: photos have been taken at its stations; "
                      "create another survey for the new plan."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The outline cannot be used: %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The obstacle %1 cannot be used: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "the wall after corner %1 crosses the wall after corner %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "corners %1 and %2 are the same point"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "at corner %1 it turns back on itself"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "it has %1 corners, and needs at least three"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "a coordinate is not a number"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "it has no area"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The outline is %1 m long, more than the %2 m that one survey may have; check its unit "
                      "(metres), or split the room."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The room has %1 corners, more than the %2 allowed; draw it more simply."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The obstacle %1 lies outside the outline; move it into the room or remove it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The ceiling cannot be at %1 m: give its height above the floor, up to %2 m."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "A plan needs from one to %1 heights of the lens, not %2."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The lens cannot be at %1 m: give heights above the floor and below the ceiling, which is at %2 m."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The height of %1 m is listed twice; list each height once."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "A step of %1 m is too fine for this room: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "A step of %1 m fits."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Rail %1 cannot lie there: it leaves the floor, or meets a wall or an obstacle; move "
                      "it, or make it shorter."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Rails %1 and %2 have a stop at the same place; move one of them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "it would take %1 stations, more than the %2 of one plan"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "its bounds would hold more than %1 stops"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "There is nothing to align in %1: no station has a photo yet; capture or import some first."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "No photo could be aligned, so no solution was recorded; see what is said of each photo."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The photos do not show where walls, floor and ceiling "
                                                   "are, and no room is drawn: the dataset has no room."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The photos do not show where walls, floor and ceiling are: the dataset's room is the drawn one."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Most of what the photos show stands more than half a metre beyond the drawn outline, which is too "
        "small or of another room: the dataset has the room that the photos show."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Nothing can be exported."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The heading of %1 of %2 photos is not known; they are "
                                                   "exported as if each looked along the room's x axis."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Could not keep a copy of the database as %1: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The room \"%1\" lies outside the outline; move its name into the room or remove it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "A room cannot be called \"%1\": give one line of up to %2 letters."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The plan names %1 rooms, more than the %2 allowed."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: it has no faces (lines \"f 1 2 3\"); export the mesh as OBJ."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: a face names vertex %2 of %3; export the mesh again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: all of its points are the same; export the mesh again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: line %2 is no vertex (\"v x y z\"); export the mesh again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: line %2 is no face (\"f 1 2 3\"); export the mesh again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Could not read %1: it has more than %2 triangles; make it simpler."),
};

} // namespace

std::span<const char* const> coreErrors() {
    return kErrors;
}

} // namespace spherewalk::ui
