// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/photo_mover.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/sketch.h"
#include "spherewalk/scene/moved_photo.h"

namespace spherewalk::ui {

namespace {

constexpr int kQuick = 8;                       ///< The first picture is reduced by this factor.
constexpr std::uintmax_t kSmallBytes = 300'000; ///< Smaller files are decoded in full at once.
constexpr int kDepthWidth = 512;                ///< Of a room's or sphere's depth.

photo::Sketch sketchOf(const Bytes& jpeg, const std::string& name) {
    return photo::sketch(jpeg, photo::readMetadata(jpeg, name), name);
}

render::DepthMap sphere(double radiusM) {
    Image<float, 1> inverseM(32, 16);
    std::fill(inverseM.values().begin(), inverseM.values().end(), static_cast<float>(1 / radiusM));
    return render::DepthMap(std::move(inverseM));
}

std::optional<render::DepthMap> depthIn(const std::filesystem::path& file) {
    try {
        return file.empty() ? std::nullopt : std::optional(render::DepthMap::read(file));
    } catch (const Error&) { // an export has removed it since; the room is then enough
        return std::nullopt;
    }
}

/// The surroundings of a photo, and what tells them.
struct Around {
    std::optional<render::DepthMap> depth;
    MovedBy by = MovedBy::Turn;
};

Around around(const ShownPhoto& photo, const Surroundings& surroundings) {
    if (auto depth = depthIn(photo.depthFile)) {
        return {std::move(depth), MovedBy::Depth};
    }
    if (surroundings.room) {
        return {render::roomDepth(*surroundings.room, photo.roomFromPhoto, kDepthWidth), MovedBy::Room};
    }
    if (surroundings.sphereRadiusM) {
        return {sphere(*surroundings.sphereRadiusM), MovedBy::Sphere};
    }
    return {};
}

} // namespace

void PhotoMover::want(const ShownPhoto& here, const ShownPhoto& there, const Surroundings& surroundings) {
    Wish wish{here, there, surroundings};
    wish.here.regions.clear(); // they change nothing of where things are
    wish.there.regions.clear();
    if (m_wish && *m_wish == wish) {
        return;
    }
    m_wish = wish;
    m_picture.reset();
    m_sentence.clear();
    m_worker.dropWaiting();
    post(wish, 1);
    std::error_code none; // reading says best what is wrong with the file
    if (std::filesystem::file_size(there.file, none) > kSmallBytes) {
        post(wish, kQuick); // the latest work is done first
    }
}

void PhotoMover::post(const Wish& wish, int denominator) {
    m_worker.post(QString::number(denominator), [this, wish, denominator]() -> BackgroundWorker::Deliver {
        try {
            return [this, wish, picture = made(wish, denominator)] {
                if (m_wish && *m_wish == wish) {
                    m_picture = picture;
                    emit moved();
                }
            };
        } catch (const Error& error) {
            return [this, wish, sentence = coreWords(error.sentence())] {
                if (m_wish && *m_wish == wish) {
                    m_sentence = sentence;
                    emit moved();
                }
            };
        }
    });
}

/// Errors: those of reading the photos; NotFound if nothing tells how they are turned.
PhotoMover::Picture PhotoMover::made(Wish wish, int denominator) {
    const std::string name = wish.there.file.string();
    const Bytes jpeg = readFile(wish.there.file);
    const bool isAligned = wish.here.isAligned && wish.there.isAligned;
    if (!isAligned) {
        const Bytes own = readFile(wish.here.file);
        const auto turn = photo::turnBetween(sketchOf(own, wish.here.file.string()), sketchOf(jpeg, name));
        if (!turn) {
            throw Error(ErrorKind::NotFound,
                        tr("The two photos cannot be compared before they are aligned: nothing tells how one "
                           "is turned against the other.")
                            .toStdString());
        }
        wish.there.roomFromPhoto.rotation =
            wish.here.roomFromPhoto.rotation * yawRotation(Radians(-turn->value()));
    }
    const Around here = wish.here.isAligned ? around(wish.here, wish.surroundings) : Around();
    const auto there = wish.there.isAligned ? depthIn(wish.there.depthFile) : std::nullopt;
    return {render::Panorama(scene::photoSeenFrom(
                {wish.here.roomFromPhoto, here.depth ? &*here.depth : nullptr},
                jpeg::decode(jpeg, name, denominator),
                {wish.there.roomFromPhoto, here.by == MovedBy::Depth && there ? &*there : nullptr})),
            here.by};
}

} // namespace spherewalk::ui
