// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_reader.h"
#include "expect_error.h"

#include "spherewalk/dataset/ros_messages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace spherewalk::dataset {

using test::ByteReader;
using test::expectError;

namespace {

constexpr std::array kTypes{RosType::Image, RosType::CompressedImage, RosType::CameraInfo,
                            RosType::PoseStamped, RosType::TfMessage};

struct SchemaField {
    std::string type;
    std::string name;
};

/// The fields of each type that a definition describes; the message itself has the name "".
std::map<std::string, std::vector<SchemaField>> typesOf(const RosSchema& schema) {
    std::map<std::string, std::vector<SchemaField>> types;
    std::string own;
    std::istringstream lines(schema.definition);
    for (std::string line; std::getline(lines, line);) {
        if (line == std::string(80, '=')) {
            std::getline(lines, line);
            EXPECT_TRUE(line.starts_with("MSG: ")) << line;
            own = line.substr(5);
            EXPECT_FALSE(types.contains(own)) << own;
        } else {
            const std::size_t blank = line.find(' ');
            types[own].push_back({line.substr(0, blank), line.substr(blank + 1)});
        }
    }
    return types;
}

const std::map<std::string, std::size_t> kSizes{
    {"bool", 1}, {"uint8", 1}, {"int32", 4}, {"uint32", 4}, {"float64", 8}};

/// Reads a message as its schema describes it, and keeps the values by their paths.
class SchemaReader {
  public:
    SchemaReader(Ros ros, RosType type, ByteView message)
        : m_ros(ros), m_types(typesOf(rosSchema(ros, type))), m_reader(message) {
        if (ros == Ros::Two) {
            EXPECT_EQ(m_reader.number(4), 0x0100U); // little-endian CDR
        }
        fields("", "");
        EXPECT_TRUE(m_reader.atEnd()) << m_reader.at();
    }

    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;

  private:
    void fields(const std::string& type, const std::string& path) {
        ASSERT_TRUE(m_types.contains(type)) << type;
        for (const SchemaField& field : m_types.at(type)) {
            value(field.type, path + field.name);
        }
    }

    void value(const std::string& type, const std::string& path) {
        if (const std::size_t bracket = type.find('['); bracket != std::string::npos) {
            array(type.substr(0, bracket), type.substr(bracket + 1, type.size() - bracket - 2), path);
        } else if (type == "string") {
            texts[path] = text();
        } else if (type == "time") { // ROS 1 has it built in
            numbers[path + ".sec"] = primitive("uint32");
            numbers[path + ".nanosec"] = primitive("uint32");
        } else if (kSizes.contains(type)) {
            numbers[path] = primitive(type);
        } else {
            fields(type, path + ".");
        }
    }

    void array(const std::string& element, const std::string& count, const std::string& path) {
        const std::size_t size =
            count.empty() ? static_cast<std::size_t>(primitive("uint32")) : std::stoul(count);
        for (std::size_t i = 0; i < size; ++i) {
            value(element, path + "." + std::to_string(i));
        }
        numbers[path + ".size"] = static_cast<double>(size);
    }

    double primitive(const std::string& type) {
        const std::size_t size = kSizes.at(type);
        if (m_ros == Ros::Two) {
            m_reader.take((size - (m_reader.at() - 4) % size) % size);
        }
        return type == "float64" ? m_reader.real() : static_cast<double>(m_reader.number(size));
    }

    std::string text() {
        const auto size = static_cast<std::size_t>(primitive("uint32"));
        std::string result(textOf(m_reader.take(size)));
        if (m_ros == Ros::Two) { // the end of a text is a zero, which counts
            EXPECT_TRUE(!result.empty() && result.back() == '\0');
            result.pop_back();
        }
        return result;
    }

    Ros m_ros;
    std::map<std::string, std::vector<SchemaField>> m_types;
    ByteReader m_reader;
};

const RosHeader kSomeHeader{77, 1'234'567'890'123'456'789, "röom"};
const Rigid3 kSomePose{Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), {1.25, -2.5, 3}};

void expectHeader(Ros ros, const SchemaReader& read, const std::string& path) {
    EXPECT_EQ(read.numbers.at(path + "stamp.sec"), 1'234'567'890);
    EXPECT_EQ(read.numbers.at(path + "stamp.nanosec"), 123'456'789);
    EXPECT_EQ(read.texts.at(path + "frame_id"), "röom");
    EXPECT_EQ(read.numbers.contains(path + "seq"), ros == Ros::One);
}

void expectPose(const SchemaReader& read, const std::string& place, const std::string& turn) {
    EXPECT_EQ(read.numbers.at(place + ".x"), 1.25);
    EXPECT_EQ(read.numbers.at(place + ".y"), -2.5);
    EXPECT_EQ(read.numbers.at(place + ".z"), 3);
    EXPECT_EQ(read.numbers.at(turn + ".x"), -0.5);
    EXPECT_EQ(read.numbers.at(turn + ".w"), 0.5);
}

} // namespace

TEST(RosSchemas, DescribeEachTypeThatTheyUseOnceAndNoOther) {
    for (const Ros ros : {Ros::One, Ros::Two}) {
        for (const RosType type : kTypes) {
            const auto types = typesOf(rosSchema(ros, type));
            std::set<std::string> used{""};
            for (const auto& [name, fields] : types) {
                EXPECT_FALSE(fields.empty()) << name;
                for (const SchemaField& field : fields) {
                    const std::string element = field.type.substr(0, field.type.find('['));
                    if (element.find('/') != std::string::npos) {
                        used.insert(element);
                    }
                }
            }
            std::set<std::string> described;
            for (const auto& [name, fields] : types) {
                described.insert(name);
            }
            EXPECT_EQ(described, used) << rosSchema(ros, type).name;
        }
    }
}

TEST(RosSchemas, HaveTheNamesAndHashesOfTheirGeneration) {
    // The hashes are those that `rosmsg md5` prints.
    EXPECT_EQ(rosSchema(Ros::One, RosType::Image).md5, "060021388200f6f0f447d0fcd9c64743");
    EXPECT_EQ(rosSchema(Ros::One, RosType::TfMessage).md5, "94810edda583a504dfda3829e70d7eec");
    std::set<std::string> hashes;
    for (const RosType type : kTypes) {
        const RosSchema one = rosSchema(Ros::One, type);
        const RosSchema two = rosSchema(Ros::Two, type);
        EXPECT_EQ(one.md5.size(), 32U);
        hashes.insert(one.md5);
        EXPECT_EQ(two.md5, "");
        const std::size_t slash = one.name.find('/');
        EXPECT_EQ(two.name, one.name.substr(0, slash) + "/msg" + one.name.substr(slash));
        EXPECT_EQ(one.definition.find("builtin_interfaces"), std::string::npos);
    }
    EXPECT_EQ(hashes.size(), kTypes.size());
}

TEST(RosMessages, AreWhatTheirSchemasDescribe) {
    for (const Ros ros : {Ros::One, Ros::Two}) {
        RgbImage picture(3, 2);
        *picture.at(2, 1) = 200;
        const SchemaReader image(ros, RosType::Image, imageMessage(ros, kSomeHeader, picture));
        expectHeader(ros, image, "header.");
        EXPECT_EQ(image.numbers.at("width"), 3);
        EXPECT_EQ(image.numbers.at("height"), 2);
        EXPECT_EQ(image.numbers.at("step"), 9);
        EXPECT_EQ(image.numbers.at("is_bigendian"), 0);
        EXPECT_EQ(image.texts.at("encoding"), "rgb8");
        EXPECT_EQ(image.numbers.at("data.size"), 18);
        EXPECT_EQ(image.numbers.at("data.15"), 200);
        const SchemaReader png(ros, RosType::CompressedImage, pngMessage(ros, kSomeHeader, bytesOf("png")));
        expectHeader(ros, png, "header.");
        EXPECT_TRUE(png.texts.at("format").starts_with("rgb8; png"));
        EXPECT_EQ(png.numbers.at("data.size"), 3);
        EXPECT_EQ(png.numbers.at("data.0"), 'p');
    }
}

TEST(RosMessages, TellPosesOfBothKinds) {
    for (const Ros ros : {Ros::One, Ros::Two}) {
        const SchemaReader pose(ros, RosType::PoseStamped, poseMessage(ros, kSomeHeader, kSomePose));
        expectHeader(ros, pose, "header.");
        expectPose(pose, "pose.position", "pose.orientation");
        for (const char* child : {"camera", "a", ""}) { // texts of all lengths before numbers of eight bytes
            const SchemaReader tf(ros, RosType::TfMessage, tfMessage(ros, kSomeHeader, child, kSomePose));
            EXPECT_EQ(tf.numbers.at("transforms.size"), 1);
            expectHeader(ros, tf, "transforms.0.header.");
            EXPECT_EQ(tf.texts.at("transforms.0.child_frame_id"), child);
            expectPose(tf, "transforms.0.transform.translation", "transforms.0.transform.rotation");
        }
    }
}

TEST(RosMessages, TellTheCamera) {
    Calibration camera;
    camera.width = 640;
    camera.height = 480;
    camera.distortionModel = "plumb_bob";
    camera.d = {0.1, -0.2, 0, 0, 0.05};
    camera.k[0] = 465.5;
    camera.p[11] = 7;
    for (const Ros ros : {Ros::One, Ros::Two}) {
        const SchemaReader info(ros, RosType::CameraInfo, cameraInfoMessage(ros, kSomeHeader, camera));
        expectHeader(ros, info, "header.");
        const bool isOne = ros == Ros::One; // which writes matrices in capital letters
        EXPECT_EQ(info.numbers.at("width"), 640);
        EXPECT_EQ(info.texts.at("distortion_model"), "plumb_bob");
        EXPECT_EQ(info.numbers.at(isOne ? "D.size" : "d.size"), 5);
        EXPECT_EQ(info.numbers.at(isOne ? "D.1" : "d.1"), -0.2);
        EXPECT_EQ(info.numbers.at(isOne ? "K.0" : "k.0"), 465.5);
        EXPECT_EQ(info.numbers.at(isOne ? "P.11" : "p.11"), 7);
        EXPECT_EQ(info.numbers.at("roi.do_rectify"), 0);
    }
}

TEST(RosStamps, KeepTheirNanosecondsAndAreNeverZero) {
    EXPECT_EQ(rosStampNs(0), 1);
    EXPECT_EQ(rosStampNs(1.5), 1'500'000'000);
    EXPECT_EQ(rosStampNs(2'000'000'000.25), 2'000'000'000'250'000'000);
    for (const double time : {-1e-9, 2147483648.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
        expectError(ErrorKind::InvalidInput, "2^31", [&] { rosStampNs(time); });
    }
}

} // namespace spherewalk::dataset
