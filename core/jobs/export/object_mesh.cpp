// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/object_overlay.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::jobs {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;

/// Where a ray enters and leaves a box; it misses the box where it would leave before it enters.
std::pair<float, float> crossing(const Eigen::Vector3f& least, const Eigen::Vector3f& greatest,
                                 const Eigen::Vector3f& origin, const Eigen::Vector3f& inverse) {
    const Eigen::Array3f a = (least - origin).array() * inverse.array();
    const Eigen::Array3f b = (greatest - origin).array() * inverse.array();
    return {a.min(b).maxCoeff(), a.max(b).minCoeff()};
}

/// A direction whose components have a reciprocal.
Eigen::Vector3f nowhereZero(const Eigen::Vector3f& direction) {
    constexpr float kLeast = 1e-20F;
    return direction.unaryExpr([](float x) { return std::abs(x) < kLeast ? std::copysign(kLeast, x) : x; });
}

} // namespace

ObjectMesh::ObjectMesh(std::vector<Eigen::Vector3f> vertices, std::vector<Triangle> triangles)
    : m_vertices(std::move(vertices)), m_triangles(std::move(triangles)) {
    const auto isThere = [this](std::uint32_t index) { return index < m_vertices.size(); };
    if (m_triangles.empty() ||
        !std::all_of(m_triangles.begin(), m_triangles.end(), [&](const Triangle& triangle) {
            return std::all_of(triangle.begin(), triangle.end(), isThere);
        })) {
        throw Error(ErrorKind::InvalidInput,
                    "A mesh has one triangle or more, between vertices that it has.");
    }
    fit();
    std::vector<Eigen::Vector3f> centres;
    centres.reserve(m_triangles.size());
    for (const Triangle& triangle : m_triangles) {
        centres.emplace_back((m_vertices[triangle[0]] + m_vertices[triangle[1]] + m_vertices[triangle[2]]) /
                             3);
    }
    m_nodes.reserve(m_triangles.size());
    build(0, static_cast<std::uint32_t>(m_triangles.size()), centres);
}

/// Brings the vertices of the triangles to the size of 1, above the origin. Other vertices count for nothing.
void ObjectMesh::fit() {
    Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d greatest = -least;
    for (const Triangle& triangle : m_triangles) {
        for (const std::uint32_t index : triangle) {
            if (!m_vertices[index].allFinite()) {
                throw Error(ErrorKind::InvalidInput, "A vertex of a mesh has three finite coordinates.");
            }
            least = least.cwiseMin(m_vertices[index].cast<double>());
            greatest = greatest.cwiseMax(m_vertices[index].cast<double>());
        }
    }
    m_longestSide = (greatest - least).maxCoeff();
    if (!(m_longestSide > 0) || !std::isfinite(1 / m_longestSide)) {
        throw Error(ErrorKind::InvalidInput, "A mesh has an extent: not all of its points are the same.");
    }
    const Eigen::Vector3d foot(0.5 * (least.x() + greatest.x()), 0.5 * (least.y() + greatest.y()), least.z());
    for (Eigen::Vector3f& vertex : m_vertices) {
        vertex = ((vertex.cast<double>() - foot) / m_longestSide).cast<float>();
    }
    m_least = ((least - foot) / m_longestSide).cast<float>();
    m_greatest = ((greatest - foot) / m_longestSide).cast<float>();
}

/// Sorts triangles into a tree of boxes, whose depth is the logarithm of their number.
void ObjectMesh::build(std::uint32_t begin, std::uint32_t end, std::vector<Eigen::Vector3f>& centres) {
    const std::size_t own = m_nodes.size();
    Node node{m_vertices[m_triangles[begin][0]], m_vertices[m_triangles[begin][0]], begin, end - begin};
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const std::uint32_t index : m_triangles[i]) {
            node.least = node.least.cwiseMin(m_vertices[index]);
            node.greatest = node.greatest.cwiseMax(m_vertices[index]);
        }
    }
    m_nodes.push_back(node);
    if (node.count <= kLeafTriangles) {
        return;
    }
    int axis = 0;
    (node.greatest - node.least).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::vector<std::uint32_t> order(end - begin);
    std::iota(order.begin(), order.end(), begin);
    std::nth_element(order.begin(), order.begin() + (middle - begin), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
    std::vector<Triangle> triangles;
    std::vector<Eigen::Vector3f> moved;
    for (const std::uint32_t i : order) {
        triangles.push_back(m_triangles[i]);
        moved.push_back(centres[i]);
    }
    std::copy(triangles.begin(), triangles.end(), m_triangles.begin() + begin);
    std::copy(moved.begin(), moved.end(), centres.begin() + begin);
    build(begin, middle, centres);
    m_nodes[own].begin = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[own].count = 0;
    build(middle, end, centres);
}

ObjectMesh ObjectMesh::cube() {
    std::vector<Eigen::Vector3f> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? 1.F : 0.F, (i & 2) != 0 ? 1.F : 0.F, (i & 4) != 0 ? 1.F : 0.F);
    }
    std::vector<Triangle> triangles;
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& face : kFaces) {
        triangles.push_back({face[0], face[1], face[2]});
        triangles.push_back({face[0], face[2], face[3]});
    }
    return {std::move(corners), std::move(triangles)};
}

std::string ObjectMesh::fingerprint() const {
    std::string key;
    for (const Triangle& triangle : m_triangles) {
        for (const std::uint32_t index : triangle) {
            const Eigen::Vector3f& at = m_vertices[index];
            key.append(reinterpret_cast<const char*>(at.data()), 3 * sizeof(float));
        }
    }
    return sha256Hex(bytesOf(key));
}

bool ObjectMesh::contains(const Eigen::Vector3d& point) const {
    return (point.array() >= m_least.cast<double>().array()).all() &&
           (point.array() <= m_greatest.cast<double>().array()).all();
}

bool ObjectMesh::meets(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, Hit& hit) const {
    // From a place beside the object on, single precision is enough, wherever the ray begins.
    const double lengthSquared = direction.squaredNorm();
    const Eigen::Vector3d middle = 0.5 * (m_least + m_greatest).cast<double>();
    const double skipped =
        std::max(0.0, (middle - origin).dot(direction) / lengthSquared - 2 / std::sqrt(lengthSquared));
    const Eigen::Vector3f from = (origin + skipped * direction).cast<float>();
    const Eigen::Vector3f along = nowhereZero(direction.cast<float>());
    const Eigen::Vector3f inverse = along.cwiseInverse();
    constexpr float kRim = 1e-6F; ///< Closes the cracks between triangles.
    float nearest = std::numeric_limits<float>::infinity();
    std::array<std::uint32_t, 64> waiting{};
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
        const Node& node = m_nodes[next];
        const auto [enters, leaves] = crossing(node.least, node.greatest, from, inverse);
        const bool isMet = leaves >= std::max(enters, 0.F) && enters < nearest;
        for (std::uint32_t i = node.begin; isMet && i < node.begin + node.count; ++i) {
            const Eigen::Vector3f& a = m_vertices[m_triangles[i][0]];
            const Eigen::Vector3f side = m_vertices[m_triangles[i][1]] - a;
            const Eigen::Vector3f other = m_vertices[m_triangles[i][2]] - a;
            const Eigen::Vector3f across = along.cross(other);
            const float volume = side.dot(across);
            const Eigen::Vector3f to = from - a;
            const Eigen::Vector3f turned = to.cross(side);
            const float u = to.dot(across) / volume;
            const float v = along.dot(turned) / volume;
            const float distance = other.dot(turned) / volume;
            // A triangle without area, or seen from its edge, gives no finite numbers.
            if (u >= -kRim && v >= -kRim && u + v <= 1 + kRim && distance > 0 && distance < nearest) {
                nearest = distance;
                hit.normal = side.cross(other).normalized();
            }
        }
        if (isMet && node.count == 0) {
            waiting[count++] = node.begin;
            ++next;
        } else if (count == 0) {
            break;
        } else {
            next = waiting[--count];
        }
    }
    if (!std::isfinite(nearest)) {
        return false;
    }
    hit.along = skipped + static_cast<double>(nearest);
    if (hit.normal.dot(along) > 0) {
        hit.normal = -hit.normal;
    }
    return true;
}

namespace {

constexpr std::uint64_t kMostBytes = 256ULL << 20;
constexpr std::string_view kBlanks = " \t\r";

/// Takes the next word of the line off.
std::string_view cutWord(std::string_view& line) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kBlanks)));
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());
    return word;
}

/// Reads the file line by line.
class ObjReader {
  public:
    explicit ObjReader(const std::filesystem::path& file) : m_name(file.string()) {}

    ObjectMesh read(std::string_view left) {
        while (!left.empty()) {
            ++m_line;
            std::string_view line = left.substr(0, left.find('\n'));
            left.remove_prefix(std::min(left.size(), line.size() + 1));
            const std::string_view word = cutWord(line);
            if (word == "v") {
                readVertex(line);
            } else if (word == "f") {
                readFace(line);
            }
        }
        if (m_triangles.empty()) {
            fail("it has no faces (lines \"f 1 2 3\"); export the mesh as OBJ.");
        }
        for (const ObjectMesh::Triangle& triangle : m_triangles) {
            for (const std::uint32_t index : triangle) {
                if (index >= m_vertices.size()) {
                    fail(text("a face names vertex ", index + 1ULL, " of ", m_vertices.size(),
                              "; export the mesh again."));
                }
            }
        }
        try {
            return {std::move(m_vertices), std::move(m_triangles)};
        } catch (const Error&) { // the only cause that is left
            fail("all of its points are the same; export the mesh again.");
        }
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ErrorKind::Corrupt, text("Could not read ", m_name, ": ", why));
    }

    void readVertex(std::string_view line) {
        Eigen::Vector3f vertex;
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> number = parseNumber(cutWord(line));
            constexpr double kMost = 1e9; // what single precision can place
            if (!number || !(std::abs(*number) < kMost)) {
                fail(text("line ", m_line, " is no vertex (\"v x y z\"); export the mesh again."));
            }
            vertex[axis] = static_cast<float>(*number);
        }
        m_vertices.push_back(vertex);
    }

    /// The index that "7", "7/1/2" or "-1" stands for.
    std::uint32_t corner(std::string_view word) const {
        const std::string_view digits = word.substr(0, word.find('/'));
        std::int64_t number = 0;
        const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const bool isNumber = failure == std::errc() && end == digits.data() + digits.size();
        const std::int64_t index =
            number < 0 ? static_cast<std::int64_t>(m_vertices.size()) + number : number - 1;
        if (!isNumber || index < 0 || index >= std::numeric_limits<std::uint32_t>::max()) {
            fail(text("line ", m_line, " is no face (\"f 1 2 3\"); export the mesh again."));
        }
        return static_cast<std::uint32_t>(index);
    }

    void readFace(std::string_view line) {
        const std::uint32_t first = corner(cutWord(line));
        std::uint32_t before = corner(cutWord(line));
        std::string_view word = cutWord(line);
        do {
            const std::uint32_t here = corner(word);
            if (m_triangles.size() == kMostObjTriangles) {
                fail(text("it has more than ", kMostObjTriangles, " triangles; make it simpler."));
            }
            m_triangles.push_back({first, before, here});
            before = here;
            word = cutWord(line);
        } while (!word.empty());
    }

    std::string m_name;
    std::size_t m_line = 0;
    std::vector<Eigen::Vector3f> m_vertices;
    std::vector<ObjectMesh::Triangle> m_triangles;
};

} // namespace

ObjectMesh readObj(const std::filesystem::path& file) {
    return ObjReader(file).read(readTextFile(file, kMostBytes));
}

PlacedMesh parseObject(std::string_view words) {
    std::vector<std::string_view> parts;
    for (std::string_view rest = words; rest.find_first_not_of(kBlanks) != std::string_view::npos;) {
        parts.push_back(cutWord(rest));
    }
    std::vector<double> numbers;
    while (!parts.empty() && numbers.size() < 5 && parseNumber(parts.back())) {
        numbers.insert(numbers.begin(), *parseNumber(parts.back()));
        parts.pop_back();
    }
    if (parts.empty() || numbers.size() < 4) {
        throw Error(
            ErrorKind::InvalidInput,
            text("\"", printable(std::string(words)),
                 "\" is no object; give \"FILE x y z size yaw\": an OBJ file or cube, its foot and its "
                 "longest side in metres, and its heading in degrees."));
    }
    const auto* end = parts.back().data() + parts.back().size(); // a file's name may have blanks
    const std::filesystem::path file(std::string(parts.front().data(), end));
    PlacedMesh object;
    object.footM = {numbers[0], numbers[1], numbers[2]};
    object.sizeM = numbers[3];
    object.yaw = Degrees(numbers.size() == 5 ? numbers[4] : 0);
    const bool isCube = file == "cube";
    object.mesh = std::make_shared<const ObjectMesh>(isCube ? ObjectMesh::cube() : readObj(file));
    object.category = isCube ? "cube" : file.stem().string();
    object.validate();
    return object;
}

} // namespace spherewalk::jobs
