// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/byte_writer.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/place/surface_files.h"

#include <cmath>
#include <limits>

namespace spherewalk::place {

namespace {

/// Of one channel, from 0 to 1. Source: IEC 61966-2-1.
double linearOfSrgb(std::uint8_t value) {
    const double stored = value / 255.0;
    return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);
}

/// Collects what glTF calls accessors: arrays one after the other in the file's binary chunk.
class GltfArrays {
  public:
    /// Adds an array that write() appends, and returns its number. target: 34962 for vertices, 34963 for
    /// indices.
    template <class Write>
    std::size_t add(int target, Json accessor, const Write& write) {
        const std::size_t begin = m_bytes.size();
        write(m_bytes);
        m_views.push_back({{"buffer", 0},
                           {"byteOffset", begin},
                           {"byteLength", m_bytes.size() - begin},
                           {"target", target}});
        m_bytes.alignFrom(0, 4);
        accessor["bufferView"] = m_accessors.size();
        m_accessors.push_back(std::move(accessor));
        return m_accessors.size() - 1;
    }

    void describe(Json& gltf) const {
        gltf["accessors"] = m_accessors;
        gltf["bufferViews"] = m_views;
        gltf["buffers"] = Json::array({{{"byteLength", m_bytes.size()}}});
    }

    Bytes take() { return m_bytes.take(); }

  private:
    ByteWriter m_bytes;
    Json m_accessors = Json::array();
    Json m_views = Json::array();
};

// Names of glTF 2.0, 3.6.2 and 3.7.2.1.
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;
constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kTriangles = 4;
constexpr std::size_t kHeaderBytes = 12;

Json numbers(const Eigen::Vector3f& vector) {
    return Json::array({vector.x(), vector.y(), vector.z()});
}

/// The vertices' arrays by their names. centreM: what positions are relative to.
Json addVertices(GltfArrays& arrays, const std::vector<SurfaceVertex>& vertices,
                 const Eigen::Vector3d& centreM) {
    const auto local = [&](const SurfaceVertex& vertex) {
        return Eigen::Vector3f((vertex.pInRoom - centreM).cast<float>());
    };
    Eigen::Vector3f least = local(vertices.front());
    Eigen::Vector3f greatest = least;
    for (const SurfaceVertex& vertex : vertices) {
        least = least.cwiseMin(local(vertex));
        greatest = greatest.cwiseMax(local(vertex));
    }
    const auto accessor = [&](int component, const char* type) {
        return Json{{"componentType", component}, {"count", vertices.size()}, {"type", type}};
    };
    Json positions = accessor(kFloat, "VEC3");
    positions["min"] = numbers(least);
    positions["max"] = numbers(greatest);
    Json colours = accessor(kUnsignedShort, "VEC4");
    colours["normalized"] = true;
    const auto each = [&](const auto& write) {
        return [&vertices, write](ByteWriter& bytes) {
            for (const SurfaceVertex& vertex : vertices) {
                write(bytes, vertex);
            }
        };
    };
    Json named;
    named["POSITION"] = arrays.add(
        kVertices, std::move(positions),
        each([&](ByteWriter& bytes, const SurfaceVertex& vertex) { bytes.numbers(local(vertex)); }));
    named["NORMAL"] = arrays.add(
        kVertices, accessor(kFloat, "VEC3"),
        each([](ByteWriter& bytes, const SurfaceVertex& vertex) { bytes.numbers(vertex.normal); }));
    named["COLOR_0"] =
        arrays.add(kVertices, std::move(colours), each([](ByteWriter& bytes, const SurfaceVertex& vertex) {
                       for (const std::uint8_t value : vertex.colour) {
                           bytes.number(static_cast<std::uint16_t>(std::lround(65535 * linearOfSrgb(value))));
                       }
                       bytes.number(std::uint16_t{65535});
                   }));
    return named;
}

void putChunk(ByteWriter& file, ByteView content, std::string_view type, char padding) {
    const std::size_t padded = (content.size() + 3) / 4 * 4;
    file.number(static_cast<std::uint32_t>(padded));
    file.put(bytesOf(type));
    file.put(content);
    file.put(bytesOf(std::string(padded - content.size(), padding)));
}

} // namespace

Bytes glbFile(const Surface& surface, const std::string& name) {
    if (surface.vertices.empty()) {
        throw Error(ErrorKind::InvalidInput, "Could not write a glTF of a surface without vertices.");
    }
    const Eigen::Vector3d centreM =
        surface.isFarAway() ? surface.vertices.front().pInRoom : Eigen::Vector3d(Eigen::Vector3d::Zero());
    GltfArrays arrays;
    const Json attributes = addVertices(arrays, surface.vertices, centreM);
    const std::size_t indices = arrays.add(
        kIndices,
        {{"componentType", kUnsignedInt}, {"count", 3 * surface.triangles.size()}, {"type", "SCALAR"}},
        [&](ByteWriter& bytes) {
            for (const auto& triangle : surface.triangles) {
                for (const std::uint32_t corner : triangle) {
                    bytes.number(corner);
                }
            }
        });
    Json gltf = {
        {"asset", {{"version", "2.0"}, {"generator", "spherewalk"}}},
        {"extensionsUsed", Json::array({"KHR_materials_unlit"})},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
        {"nodes",
         Json::array({{{"name", name},
                       {"children", Json::array({1})},
                       {"rotation", Json::array({-std::sqrt(0.5), 0, 0, std::sqrt(0.5)})}},
                      {{"mesh", 0}, {"translation", Json::array({centreM.x(), centreM.y(), centreM.z()})}}})},
        {"materials", Json::array({{{"name", "photographed"},
                                    {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}},
                                    {"extensions", {{"KHR_materials_unlit", Json::object()}}}}})},
        {"meshes", Json::array({{{"primitives", Json::array({{{"attributes", attributes},
                                                              {"indices", indices},
                                                              {"material", 0},
                                                              {"mode", kTriangles}}})}}})}};
    arrays.describe(gltf);
    const std::string json = gltf.dump();
    ByteWriter chunks;
    putChunk(chunks, bytesOf(json), "JSON", ' ');
    putChunk(chunks, arrays.take(), std::string_view("BIN\0", 4), '\0');
    if (chunks.size() > std::numeric_limits<std::uint32_t>::max() - kHeaderBytes) {
        throw Error(ErrorKind::Unsupported, text("Could not write a glTF of ", surface.vertices.size(),
                                                 " vertices: one file holds 4 GB. Take larger voxels, or "
                                                 "join triangles."));
    }
    ByteWriter file;
    file.put(bytesOf("glTF"));
    file.number(std::uint32_t{2});
    file.number(static_cast<std::uint32_t>(kHeaderBytes + chunks.size()));
    file.put(chunks.view());
    return file.take();
}

} // namespace spherewalk::place
