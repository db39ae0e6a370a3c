// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>
#include <QUrl>

#include <span>
#include <string>
#include <utility>

namespace spherewalk::ui {

/// A place of the window, or of its guide, where something can be done about what a sentence says.
enum class Cure {
    None,
    Start,         ///< The start page, where surveys are opened.
    Plan,          ///< The plan, with outline, obstacles and rails.
    Capture,       ///< Where photos are taken.
    CameraAddress, ///< The field with the camera's address.
    Connecting,    ///< What the guide says of a camera that does not answer.
    Exposure,      ///< The settings that every photo of the survey is taken with.
    Review,        ///< The photos that are doubtful or failed.
    Regions,       ///< The photos that have private regions.
    Align,
    ExportFolder, ///< The field with the dataset's folder.
    ExportDepth,  ///< The choice of the scene model, which says how depth comes into a dataset.
};

/// Sentences in the user's language, and the place where they are cured.
struct Told {
    QString text;
    Cure cure = Cure::None;

    Told() = default;

    // Most sentences have no cure, and read as they are.
    Told(QString sentence, Cure where = Cure::None) : text(std::move(sentence)), cure(where) {}

    bool isEmpty() const { return text.isEmpty(); }
};

/// Returns what coreWords() returns, with the cure of the first sentence that has one.
Told coreTold(const QString& text);
Told coreTold(const std::string& text);

/// Returns the link to a place: "spherewalk:align", "spherewalk:capture/address",
/// "spherewalk:guide/connecting". It is empty for Cure::None. MainWindow follows such links, wherever they
/// are clicked.
QUrl linkTo(Cure cure);

/// The scheme of these links.
inline constexpr auto kLinkScheme = "spherewalk";

/// Returns the words of a link, such as "Go to Align".
QString linkWords(Cure cure);

/// A sentence of the core that has a cure, as coreErrors() or the other sentences of coreWords() have it.
struct CuredSentence {
    const char* sentence;
    Cure cure;
};

std::span<const CuredSentence> curedSentences();

} // namespace spherewalk::ui

Q_DECLARE_METATYPE(spherewalk::ui::Told)
