// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/photo_decoder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>

namespace spherewalk::ui {

namespace {

constexpr std::size_t kMostKept = 4; ///< of 43 MB each, for photos of 5376 x 2688 pixels
constexpr int kQuickReduction = 4;
constexpr int kQuickWidth = 2048; ///< what is not wider is decoded in full at once

/// By how much the photo can be reduced at first and still be a panorama.
int quickDenominator(const jpeg::Info& info) {
    const bool isEven = info.width % kQuickReduction == 0 && info.height % kQuickReduction == 0;
    return info.width > kQuickWidth && isEven ? kQuickReduction : 1;
}

} // namespace

PhotoDecoder::PhotoDecoder(QObject* parent) : QObject(parent) {
}

void PhotoDecoder::want(const std::vector<File>& files) {
    m_wanted = files;
    m_worker.dropWaiting();
    for (auto file = files.rbegin(); file != files.rend(); ++file) { // the first one is to be done first
        const Entry& found = entryOf(*file);
        if (found.sentence.isEmpty() && (!found.decoded || found.decoded->denominator > 1)) {
            decode(*file, found.decoded ? 1 : 0);
        }
    }
    while (m_entries.size() > std::max(kMostKept, files.size())) {
        m_entries.pop_back();
    }
}

std::optional<PhotoDecoder::Decoded> PhotoDecoder::find(const File& file) const {
    const Entry* found = entry(file);
    return found != nullptr ? found->decoded : std::nullopt;
}

QString PhotoDecoder::sentence(const File& file) const {
    const Entry* found = entry(file);
    return found != nullptr ? found->sentence : QString();
}

bool PhotoDecoder::isWanted(const File& file) const {
    return std::find(m_wanted.begin(), m_wanted.end(), file) != m_wanted.end();
}

PhotoDecoder::Entry& PhotoDecoder::entryOf(const File& file) {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.file == file; });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
    } else {
        m_entries.push_front({file, std::nullopt, {}});
    }
    return m_entries.front();
}

const PhotoDecoder::Entry* PhotoDecoder::entry(const File& file) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.file == file; });
    return found != m_entries.end() ? &*found : nullptr;
}

/// denominator: 0 for the one that is quick.
void PhotoDecoder::decode(const File& file, int denominator) {
    m_worker.post(
        QString::fromStdString(file.string()), [this, file, denominator]() -> BackgroundWorker::Deliver {
            try {
                const Bytes bytes = readFile(file);
                const int by =
                    denominator > 0 ? denominator : quickDenominator(jpeg::readInfo(bytes, file.string()));
                const Decoded decoded{render::Panorama(jpeg::decode(bytes, file.string(), by)), by};
                return [this, file, decoded] { keep(file, decoded, {}); };
            } catch (const Error& error) {
                const QString sentence = QString::fromStdString(error.sentence());
                return [this, file, sentence] { keep(file, std::nullopt, sentence); };
            }
        });
}

void PhotoDecoder::keep(const File& file, std::optional<Decoded> decoded, const QString& sentence) {
    if (!isWanted(file)) {
        return;
    }
    Entry& entry = entryOf(file);
    entry.decoded = std::move(decoded);
    entry.sentence = sentence;
    if (entry.decoded && entry.decoded->denominator > 1) {
        decode(file, 1);
    }
    emit this->decoded();
}

} // namespace spherewalk::ui
