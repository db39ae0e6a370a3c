// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/coco.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <utility>

namespace spherewalk::dataset {

namespace {

constexpr std::uint16_t kRoom = 0;

/// Pixels of a picture, and the box about them.
class Extent {
  public:
    void add(int x, int y) {
        ++m_area;
        m_left = std::min(m_left, x);
        m_top = std::min(m_top, y);
        m_right = std::max(m_right, x + 1);
        m_bottom = std::max(m_bottom, y + 1);
    }

    std::size_t area() const { return m_area; }

    /// As COCO has boxes: left, top, width, height. Range: not without pixels.
    Json box() const { return {m_left, m_top, m_right - m_left, m_bottom - m_top}; }

  private:
    std::size_t m_area = 0;
    int m_left = 1 << 30;
    int m_top = 1 << 30;
    int m_right = 0;
    int m_bottom = 0;
};

/// Where an object would be seen, and what is seen there.
struct Sighting {
    Extent whole;
    Extent visible;
    std::size_t room = 0;   ///< Pixels in which the room hides it.
    std::size_t others = 0; ///< Pixels in which other objects hide it.

    double shareOf(std::size_t pixels) const {
        return static_cast<double>(pixels) / static_cast<double>(whole.area());
    }
};

Sighting sightingOf(const LabelledObject& object, const render::LabelImage& labels) {
    if (object.whole.width() != labels.width() || object.whole.height() != labels.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The mask of object ", object.instance, " has ", object.whole.width(), " x ",
                         object.whole.height(), " pixels, the labels ", labels.width(), " x ",
                         labels.height(), "."));
    }
    Sighting sighting;
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (*object.whole.at(x, y) == 0) {
                continue;
            }
            sighting.whole.add(x, y);
            const std::uint16_t label = *labels.at(x, y);
            if (label == object.instance) {
                sighting.visible.add(x, y);
            } else {
                ++(label == kRoom ? sighting.room : sighting.others);
            }
        }
    }
    return sighting;
}

Json placeJson(const Eigen::Vector3d& place) {
    return {place.x(), place.y(), place.z()};
}

Json turnJson(const Eigen::Quaterniond& turn) {
    return {{"w", turn.w()}, {"x", turn.x()}, {"y", turn.y()}, {"z", turn.z()}};
}

Json boxJson(const Rigid3& frameFromBox, const Eigen::Vector3d& sizeM) {
    return {{"center_m", placeJson(frameFromBox.translation)},
            {"size_m", placeJson(sizeM)},
            {"rotation", turnJson(frameFromBox.rotation)}};
}

Json categoryJson(std::size_t id, std::string_view name) {
    return {{"id", id}, {"name", name}, {"supercategory", id == kRoom ? "room" : "object"}};
}

std::size_t categoryId(std::span<const std::string> categories, const std::string& name) {
    const auto found = std::find(categories.begin(), categories.end(), name);
    if (found == categories.end()) {
        throw Error(ErrorKind::InvalidInput, text("No category of labels is called ", name, "."));
    }
    return static_cast<std::size_t>(found - categories.begin()) + 1;
}

Json annotationJson(const LabelledFrame& frame, const LabelledObject& object, const Sighting& sighting) {
    return {{"instance", object.instance},
            {"segmentation",
             {{"size", {frame.labels.height(), frame.labels.width()}},
              {"counts", runLengths(frame.labels, object.instance)}}},
            {"area", sighting.visible.area()},
            {"bbox", sighting.visible.box()},
            {"iscrowd", 0},
            {"whole_area", sighting.whole.area()},
            {"whole_bbox", sighting.whole.box()},
            {"visible_share", sighting.shareOf(sighting.visible.area())},
            {"hidden_by_room_share", sighting.shareOf(sighting.room)},
            {"hidden_by_objects_share", sighting.shareOf(sighting.others)},
            {"box_in_camera", boxJson(frame.roomFromCamera.inverse() * object.roomFromBox, object.sizeM)},
            {"box_in_room", boxJson(object.roomFromBox, object.sizeM)}};
}

Json imageJson(const LabelledFrame& frame) {
    return {{"file_name", frame.file},
            {"width", frame.labels.width()},
            {"height", frame.labels.height()},
            {"labels_file", frame.labelsFile},
            {"time_s", frame.timeS},
            {"room_from_camera",
             {{"position_m", placeJson(frame.roomFromCamera.translation)},
              {"rotation", turnJson(frame.roomFromCamera.rotation)}}}};
}

} // namespace

std::vector<std::uint32_t> runLengths(const render::LabelImage& labels, std::uint16_t label) {
    std::vector<std::uint32_t> runs{0};
    bool isIn = false;
    for (int x = 0; x < labels.width(); ++x) {
        for (int y = 0; y < labels.height(); ++y) {
            if ((*labels.at(x, y) == label) != isIn) {
                isIn = !isIn;
                runs.push_back(0);
            }
            ++runs.back();
        }
    }
    return runs;
}

Json cocoJson(std::span<const std::string> categories, std::size_t frames,
              const std::function<LabelledFrame(std::size_t frame)>& frameAt) {
    Json json{{"info", {{"description", "Objects that Spherewalk laid into views of a room"}}},
              {"images", Json::array()},
              {"annotations", Json::array()},
              {"categories", Json::array({categoryJson(kRoom, "room")})}};
    for (std::size_t i = 0; i < categories.size(); ++i) {
        json["categories"].push_back(categoryJson(i + 1, categories[i]));
    }
    for (std::size_t i = 0; i < frames; ++i) {
        const LabelledFrame frame = frameAt(i);
        Json hidden = Json::array();
        for (const LabelledObject& object : frame.objects) {
            const std::size_t category = categoryId(categories, object.category);
            const Sighting sighting = sightingOf(object, frame.labels);
            if (sighting.visible.area() > 0) {
                Json annotation = annotationJson(frame, object, sighting);
                annotation["id"] = json["annotations"].size() + 1; // COCO's evaluation takes 0 for none
                annotation["image_id"] = i;
                annotation["category_id"] = category;
                json["annotations"].push_back(std::move(annotation));
            } else if (sighting.whole.area() > 0) {
                hidden.push_back(object.instance);
            }
        }
        Json image = imageJson(frame);
        image["id"] = i;
        image["hidden_instances"] = std::move(hidden);
        json["images"].push_back(std::move(image));
    }
    return json;
}

} // namespace spherewalk::dataset
