// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/object_overlay.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::jobs {

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

} // namespace spherewalk::jobs
