// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

#include <Eigen/Core>

#include <array>
#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace spherewalk::test {

struct PlyVertex {
    Eigen::Vector3d pInRoom;
    Eigen::Vector3d normal;
    std::array<int, 3> colour;
    double confidence;
    int photos;
};

struct Ply {
    std::vector<PlyVertex> vertices;
    std::vector<std::array<int, 3>> triangles;
};

/// Reads a PLY by what its header says, and not by what our writer is known to do.
class PlyReader {
  public:
    explicit PlyReader(ByteView bytes) : m_bytes(bytes) { readHeader(); }

    Ply read() {
        Ply ply;
        for (std::size_t i = 0; i < m_vertexCount; ++i) {
            std::map<std::string, double> row;
            for (const auto& [type, name] : m_properties) {
                row[name] = number(type);
            }
            ply.vertices.push_back({{row.at("x"), row.at("y"), row.at("z")},
                                    {row.at("nx"), row.at("ny"), row.at("nz")},
                                    {static_cast<int>(row.at("red")), static_cast<int>(row.at("green")),
                                     static_cast<int>(row.at("blue"))},
                                    row.at("confidence"),
                                    static_cast<int>(row.at("photos"))});
        }
        for (std::size_t i = 0; i < m_faceCount; ++i) {
            expect(number("uchar") == 3);
            std::array<int, 3> face{};
            for (int& corner : face) {
                corner = static_cast<int>(number("int"));
            }
            ply.triangles.push_back(face);
        }
        expect(m_at == m_bytes.size());
        return ply;
    }

  private:
    static void expect(bool isTrue) {
        if (!isTrue) {
            throw Error(ErrorKind::Corrupt, "This is no PLY as it was expected.");
        }
    }

    void readHeader() {
        std::string line;
        std::string element;
        while (line != "end_header") {
            line.clear();
            for (; m_at < m_bytes.size() && m_bytes[m_at] != '\n'; ++m_at) {
                line += static_cast<char>(m_bytes[m_at]);
            }
            expect(m_at++ < m_bytes.size());
            std::istringstream words(line);
            std::string word;
            std::string second;
            std::string third;
            words >> word >> second >> third;
            if (word == "format") {
                expect(second == "binary_little_endian");
            } else if (word == "element") {
                element = second;
                (element == "vertex" ? m_vertexCount : m_faceCount) = std::stoul(third);
            } else if (word == "property" && element == "vertex") {
                m_properties.emplace_back(second, third);
            }
        }
    }

    template <class Number>
    double take() {
        Number value;
        expect(m_at + sizeof(Number) <= m_bytes.size());
        std::memcpy(&value, m_bytes.data() + m_at, sizeof(Number));
        m_at += sizeof(Number);
        return static_cast<double>(value);
    }

    double number(const std::string& type) {
        expect(type == "float" || type == "double" || type == "uchar" || type == "int");
        return type == "float"    ? take<float>()
               : type == "double" ? take<double>()
               : type == "int"    ? take<std::int32_t>()
                                  : take<std::uint8_t>();
    }

    ByteView m_bytes;
    std::size_t m_at = 0;
    std::size_t m_vertexCount = 0;
    std::size_t m_faceCount = 0;
    std::vector<std::pair<std::string, std::string>> m_properties;
};

inline Ply readPly(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file);
    return PlyReader(bytes).read();
}

} // namespace spherewalk::test
