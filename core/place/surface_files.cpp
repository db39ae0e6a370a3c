// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/surface_files.h"

#include "spherewalk/base/byte_writer.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>

namespace spherewalk::place {

namespace {

std::string plyHeader(const Surface& surface, std::string_view position) {
    std::string header = text("ply\nformat binary_little_endian 1.0\ncomment spherewalk, metres, z up\n",
                              "element vertex ", surface.vertices.size(), "\n");
    for (const char* coordinate : {"x", "y", "z"}) {
        header += text("property ", position, " ", coordinate, "\n");
    }
    return header + text("property float nx\nproperty float ny\nproperty float nz\n"
                         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                         "property float confidence\nproperty uchar photos\nelement face ",
                         surface.triangles.size(), "\nproperty list uchar int vertex_indices\nend_header\n");
}

} // namespace

Bytes plyFile(const Surface& surface) {
    const bool withDoubles = surface.isFarAway();
    ByteWriter file;
    file.put(bytesOf(plyHeader(surface, withDoubles ? "double" : "float")));
    for (const SurfaceVertex& vertex : surface.vertices) {
        for (const double coordinate : vertex.pInRoom) {
            withDoubles ? file.number(coordinate) : file.number(static_cast<float>(coordinate));
        }
        file.numbers(vertex.normal);
        file.put(vertex.colour);
        file.number(vertex.confidence);
        file.number(vertex.photos);
    }
    for (const auto& triangle : surface.triangles) {
        file.number(std::uint8_t{3});
        for (const std::uint32_t corner : triangle) {
            file.number(static_cast<std::int32_t>(corner));
        }
    }
    return file.take();
}

std::string objFile(const Surface& surface) {
    std::string file = "# spherewalk, metres, z up\n";
    const auto add = [&](std::string_view word, const auto& values, int digits) {
        file += word;
        for (const auto value : values) {
            file += " " + fixed(value, digits);
        }
    };
    for (const SurfaceVertex& vertex : surface.vertices) {
        add("v", vertex.pInRoom, 4);
        add("", std::array{vertex.colour[0] / 255.0, vertex.colour[1] / 255.0, vertex.colour[2] / 255.0}, 4);
        file += "\n";
    }
    for (const SurfaceVertex& vertex : surface.vertices) {
        add("vn", vertex.normal, 3);
        file += "\n";
    }
    for (const auto& triangle : surface.triangles) {
        file += "f";
        for (const std::uint32_t corner : triangle) {
            file += text(" ", corner + 1, "//", corner + 1);
        }
        file += "\n";
    }
    return file;
}

} // namespace spherewalk::place
