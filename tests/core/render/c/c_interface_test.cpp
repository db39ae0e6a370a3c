// SPDX-License-Identifier: Apache-2.0
// That the C interface does what the C++ one does.
#include "c/c_interface_c99.h"
#include "c/c_test.h"
#include "c/enums.h"

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/sensor.h"

#include <thread>

namespace spherewalk::render {

using test::CInterface;
using test::expectStatus;
using test::ready;

TEST_F(CInterface, IsOfTheProjectsVersion) {
    EXPECT_STREQ(spherewalk_version(), SPHEREWALK_PROJECT_VERSION);
    EXPECT_EQ(spherewalk_version_number(), SPHEREWALK_VERSION_NUMBER);
}

TEST_F(CInterface, ServesAPlainCProgram) {
    const std::string yaml = cameraInfoYaml(CameraIntrinsics::pinhole(40, 30, 1), "c");
    const char* wrong = spherewalkC99Session(folder.path().c_str(), yaml.c_str());
    EXPECT_EQ(wrong, nullptr) << wrong;
}

TEST_F(CInterface, ListsTheDataset) {
    info.cameras.push_back({"head", {100, 80, 50, 51, 49, 39, LensModel::Equidistant, {0.1, 0.2, 0.3, 0.4}}});
    info.photos[1].station = "S2";
    info.photos[1].positionSigmaM = Eigen::Vector3d(0.01, 0.02, 0.03);
    info.photos[1].rotationSigma = RotationSigma{Radians(0.1), Radians(0.2), Radians(0.3)};
    writeFile(folder / kDatasetFile, bytesOf(toJson(info).dump()));
    reopen();
    auto all = ready(spherewalk_dataset_info_init);
    ASSERT_EQ(spherewalk_dataset_get_info(dataset.get(), &all), SPHEREWALK_OK);
    EXPECT_STREQ(all.name, "test");
    EXPECT_EQ(all.photo_count, 2U);
    EXPECT_EQ(all.camera_count, 1U);
    EXPECT_EQ(all.sphere_radius_m, 2.0);

    auto photo = ready(spherewalk_photo_init);
    ASSERT_EQ(spherewalk_dataset_get_photo(dataset.get(), 0, &photo), SPHEREWALK_OK);
    EXPECT_TRUE(std::isnan(photo.position_sigma_m[0]) && std::isnan(photo.rotation_sigma_rad[2]));
    ASSERT_EQ(spherewalk_dataset_get_photo(dataset.get(), 1, &photo), SPHEREWALK_OK);
    EXPECT_STREQ(photo.file, "photos/1.jpg");
    EXPECT_STREQ(photo.station, "S2");
    EXPECT_STREQ(photo.rotation_source, "imported");
    EXPECT_EQ(photo.width, 256);
    EXPECT_EQ(photo.room_from_photo.x, 1);
    EXPECT_EQ(photo.room_from_photo.qw, 1);
    EXPECT_EQ(photo.position_sigma_m[2], 0.03);
    EXPECT_DOUBLE_EQ(photo.rotation_sigma_rad[1], 0.2);

    const char* name = nullptr;
    auto head = ready(spherewalk_intrinsics_init);
    ASSERT_EQ(spherewalk_dataset_get_camera(dataset.get(), 0, &name, &head), SPHEREWALK_OK);
    EXPECT_STREQ(name, "head");
    EXPECT_EQ(head.fy, 51);
    EXPECT_EQ(head.lens, SPHEREWALK_LENS_EQUIDISTANT);
    EXPECT_EQ(head.distortion_count, 4);
    EXPECT_EQ(head.distortion[3], 0.4);
}

TEST_F(CInterface, ReadsCamerasFromFilesAndText) {
    const CameraIntrinsics expected{100,
                                    80,
                                    50,
                                    51,
                                    49,
                                    39,
                                    LensModel::RationalPolynomial,
                                    {1e-1, 2e-2, 3e-3, 4e-4, 5e-5, 6e-6, 7e-7, 8e-8}};
    const std::string yaml = cameraInfoYaml(expected, "robot");
    writeFile(folder / "robot.yaml", bytesOf(yaml));
    spherewalk_camera* made = nullptr;
    for (const bool isFile : {true, false}) {
        ASSERT_EQ(isFile ? spherewalk_camera_read((folder / "robot.yaml").c_str(), &made)
                         : spherewalk_camera_parse(yaml.data(), yaml.size(), &made),
                  SPHEREWALK_OK);
        auto read = ready(spherewalk_intrinsics_init);
        ASSERT_EQ(spherewalk_camera_get_intrinsics(made, &read), SPHEREWALK_OK);
        spherewalk_camera_destroy(made);
        EXPECT_EQ(read.width, 100);
        EXPECT_EQ(read.cy, 39);
        EXPECT_EQ(read.lens, SPHEREWALK_LENS_RATIONAL_POLYNOMIAL);
        EXPECT_EQ(std::vector<double>(read.distortion, read.distortion + read.distortion_count),
                  expected.distortion);
    }
}

TEST_F(CInterface, TurnsBodiesToOpticalFrames) {
    test::Random random(71);
    for (int i = 0; i < 20; ++i) {
        const Rigid3 body{random.rotation(), random.vector(10)};
        spherewalk_pose pose = test::cPose(body);
        ASSERT_EQ(spherewalk_optical_pose(&pose, &pose), SPHEREWALK_OK);
        const Eigen::Quaterniond expected = body.rotation * bodyFromOptical();
        EXPECT_LT(angleBetween(expected, Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz)).value(),
                  1e-12);
        EXPECT_EQ(pose.x, body.translation.x());
    }
}

// Same bytes and same report, whatever the options, the lens, the pose and the caller's stride.
TEST_F(CInterface, RendersWhatTheLibraryRenders) {
    test::Random random(72);
    SCOPED_TRACE(random.seed());
    const Renderer reference(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    for (int i = 0; i < 40; ++i) {
        const auto intrinsics =
            CameraIntrinsics::pinhole(random.integer(1, 90), random.integer(1, 70), random.uniform(0.2, 2.5));
        auto given = ready(spherewalk_intrinsics_init);
        ASSERT_EQ(spherewalk_intrinsics_init(&given, sizeof given), SPHEREWALK_OK);
        given.width = intrinsics.width;
        given.height = intrinsics.height;
        given.fx = intrinsics.fx;
        given.fy = intrinsics.fy;
        given.cx = intrinsics.cx;
        given.cy = intrinsics.cy;
        const auto model = make(given);
        const Rigid3 pose{random.rotation(), random.vector(0.6)};
        auto wanted = ready(spherewalk_view_options_init);
        wanted.scene = random.integer(0, 2);
        wanted.sampling = random.integer(0, 6);
        wanted.threads = random.integer(0, 3);
        wanted.is_exact = random.integer(0, 4) == 0;
        const View expected = reference.render(
            CameraModel(intrinsics), pose,
            {sceneOf(wanted.scene), wanted.threads, samplingOf(wanted.sampling), 40, wanted.is_exact != 0});

        const auto rowBytes = static_cast<std::size_t>(3 * given.width);
        const std::size_t stride = rowBytes + static_cast<std::size_t>(random.integer(0, 20));
        std::vector<std::uint8_t> buffer(stride * static_cast<std::size_t>(given.height - 1) + rowBytes, 7);
        auto view = ready(spherewalk_view_init);
        view.rgb = {buffer.data(), buffer.size(), stride};
        auto report = ready(spherewalk_report_init);
        const spherewalk_pose at = test::cPose(pose);
        ASSERT_EQ(spherewalk_renderer_render(renderer.get(), model.get(), &at, &wanted, &view, &report),
                  SPHEREWALK_OK)
            << spherewalk_last_error();
        for (int y = 0; y < given.height; ++y) {
            const auto row = buffer.begin() + static_cast<std::ptrdiff_t>(stride) * y;
            ASSERT_TRUE(
                std::equal(row, row + static_cast<std::ptrdiff_t>(rowBytes), expected.picture.at(0, y)));
            ASSERT_TRUE(y + 1 == given.height ||
                        std::all_of(row + static_cast<std::ptrdiff_t>(rowBytes),
                                    row + static_cast<std::ptrdiff_t>(stride), [](int b) { return b == 7; }));
        }
        EXPECT_EQ(report.photo, expected.report.photo);
        EXPECT_EQ(report.scene, cScene(expected.report.scene));
        EXPECT_EQ(report.sampling, cSampling(expected.report.sampling));
        EXPECT_EQ(report.origin, SPHEREWALK_ORIGIN_PHOTO);
        EXPECT_EQ(report.offset_m, expected.report.offsetM);
        EXPECT_EQ(report.parallax_px, expected.report.parallaxPx);
        EXPECT_EQ(report.trust, expected.report.trust);
        EXPECT_EQ(report.is_outside, expected.report.isOutside ? 1 : 0);
        EXPECT_EQ(report.sees_place, expected.report.seesPlace ? 1 : 0);
        EXPECT_EQ(report.seen_share, expected.report.seenShare);
        EXPECT_EQ(report.filled_share, expected.report.filledShare);
        EXPECT_EQ(report.is_verified, 1);
        EXPECT_EQ(report.is_whole_decode, expected.report.isWholeDecode ? 1 : 0);
    }
}

namespace {

/// A picture of the library and the same in memory with gaps between its rows.
template <class Picture>
struct Rows {
    explicit Rows(const Picture& picture, std::size_t gapBytes = 12) {
        stride = picture.row(0).size_bytes() + gapBytes;
        bytes.resize(stride * static_cast<std::size_t>(picture.height()) - gapBytes);
        for (int y = 0; y < picture.height(); ++y) {
            std::memcpy(bytes.data() + stride * static_cast<std::size_t>(y), picture.at(0, y),
                        picture.row(y).size_bytes());
        }
    }

    spherewalk_source source() const { return {bytes.data(), bytes.size(), stride}; }

    spherewalk_buffer buffer() { return {bytes.data(), bytes.size(), stride}; }

    std::size_t stride;
    std::vector<std::uint8_t> bytes;
};

/// Noise of which a part has no depth.
Overlay noise(const CameraIntrinsics& camera, test::Random& random) {
    Overlay overlay;
    overlay.camera = camera;
    overlay.alpha = random.integer(0, 1) == 0 ? Alpha::Straight : Alpha::Premultiplied;
    overlay.picture = RgbaImage(camera.width, camera.height);
    overlay.depth = DepthImage(camera.width, camera.height);
    for (std::uint8_t& value : overlay.picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    for (float& depth : overlay.depth.values()) {
        depth = static_cast<float>(random.uniform(-1, 4));
    }
    if (random.integer(0, 1) == 0) {
        overlay.roomDepth = overlay.depth;
        for (float& depth : overlay.roomDepth.values()) {
            depth += static_cast<float>(random.uniform(-0.01, 0.01));
        }
    }
    return overlay;
}

} // namespace

TEST_F(CInterface, GivesDepthTrustAndOverlaysAsTheLibrary) {
    test::Random random(73);
    SCOPED_TRACE(random.seed());
    const Renderer reference(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    const auto lens = CameraIntrinsics::pinhole(kWidth, kHeight, 1.2);
    auto other = ready(spherewalk_intrinsics_init);
    ASSERT_EQ(spherewalk_intrinsics_pinhole(50, 40, 1.4, &other), SPHEREWALK_OK);
    for (int i = 0; i < 20; ++i) {
        const Rigid3 pose{random.rotation(), random.vector(0.6)};
        std::vector<Overlay> overlays{noise(lens, random),
                                      noise(CameraIntrinsics::pinhole(50, 40, 1.4), random)};
        overlays[1].shadow = Image<float, 1>(50, 40);
        for (float& share : overlays[1].shadow.values()) {
            share = static_cast<float>(random.uniform(0, 1));
        }
        ViewOptions options;
        options.scene = random.integer(0, 2) == 0 ? SceneKind::None : SceneKind::Sphere;
        options.wantsDepth = options.wantsTrust = true;
        options.overlays = overlays;
        options.compose = {0.1, 0.02, random.integer(0, 1) == 0 ? Edges::Hard : Edges::Soft};
        View expected = reference.render(CameraModel(lens), pose, options);
        if (expected.depth.empty()) {
            expected.depth = DepthImage(kWidth, kHeight);
            std::fill(expected.depth.values().begin(), expected.depth.values().end(), HUGE_VALF);
        }

        std::vector<Rows<RgbaImage>> pictures;
        std::vector<Rows<DepthImage>> depths;
        std::vector<Rows<DepthImage>> rooms;
        Rows shadow(overlays[1].shadow);
        std::vector<spherewalk_overlay> laid(2, ready(spherewalk_overlay_init));
        laid[1].shadow = shadow.source();
        for (const Overlay& overlay : overlays) {
            pictures.emplace_back(overlay.picture);
            depths.emplace_back(overlay.depth);
            rooms.emplace_back(overlay.roomDepth.empty() ? overlay.depth : overlay.roomDepth);
        }
        for (std::size_t k = 0; k < 2; ++k) {
            laid[k].camera = k == 0 ? nullptr : &other;
            laid[k].alpha = overlays[k].alpha == Alpha::Straight ? SPHEREWALK_ALPHA_STRAIGHT
                                                                 : SPHEREWALK_ALPHA_PREMULTIPLIED;
            laid[k].rgba = pictures[k].source();
            laid[k].depth = depths[k].source();
            if (!overlays[k].roomDepth.empty()) {
                laid[k].room_depth = rooms[k].source();
            }
        }
        const std::vector<const spherewalk_overlay*> pointers{&laid[0], &laid[1]};
        auto wanted = ready(spherewalk_view_options_init);
        wanted.scene = cScene(*options.scene);
        wanted.overlays = pointers.data();
        wanted.overlay_count = 2;
        wanted.overlay_tolerance_m = 0.1;
        wanted.overlay_tolerance_share = 0.02;
        wanted.overlay_edges =
            options.compose.edges == Edges::Hard ? SPHEREWALK_EDGES_HARD : SPHEREWALK_EDGES_SOFT;

        Rows rgb{RgbImage(kWidth, kHeight)};
        Rows depth{DepthImage(kWidth, kHeight)};
        Rows errorPx{DepthImage(kWidth, kHeight)};
        Rows flags{MaskImage(kWidth, kHeight)};
        Rows overlaid{MaskImage(kWidth, kHeight)};
        auto into = ready(spherewalk_view_init);
        into.rgb = rgb.buffer();
        into.depth = depth.buffer();
        into.error_px = errorPx.buffer();
        into.flags = flags.buffer();
        into.overlaid = overlaid.buffer();
        const spherewalk_pose at = test::cPose(pose);
        ASSERT_EQ(spherewalk_renderer_render(renderer.get(), camera.get(), &at, &wanted, &into, nullptr),
                  SPHEREWALK_OK)
            << spherewalk_last_error();
        EXPECT_EQ(rgb.bytes, Rows(expected.picture).bytes);
        EXPECT_EQ(depth.bytes, Rows(expected.depth).bytes);
        EXPECT_EQ(errorPx.bytes, Rows(expected.trust.errorPx).bytes);
        EXPECT_EQ(flags.bytes, Rows(expected.trust.flags).bytes);
        EXPECT_EQ(overlaid.bytes, Rows(expected.overlaid).bytes);
    }
}

TEST_F(CInterface, GivesTheLightAsTheLibrary) {
    const Renderer reference(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    const LightProbe expected = lightProbe(reference, {0.2, 0.1, 0}, {64, SceneKind::Sphere, 0, true});
    auto wanted = ready(spherewalk_probe_options_init);
    EXPECT_EQ(wanted.width, ProbeOptions().width);
    wanted.width = 64;
    wanted.scene = SPHEREWALK_SCENE_SPHERE;
    Rows radiance{RadianceImage(64, 32)};
    Rows clipped{MaskImage(64, 32)};
    auto into = ready(spherewalk_probe_init);
    into.radiance = radiance.buffer();
    into.clipped = clipped.buffer();
    auto light = ready(spherewalk_light_init);
    const double place[] = {0.2, 0.1, 0};
    ASSERT_EQ(spherewalk_renderer_probe(renderer.get(), place, &wanted, &into, &light), SPHEREWALK_OK)
        << spherewalk_last_error();
    EXPECT_EQ(radiance.bytes, Rows(expected.radiance).bytes);
    EXPECT_EQ(clipped.bytes, Rows(expected.clipped).bytes);
    const LightHarmonics harmonics = lightHarmonics(expected.radiance);
    const DominantLight dominant = dominantLight(harmonics);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(light.towards[c], dominant.towards[c]);
        EXPECT_EQ(light.irradiance[c], dominant.irradiance[c]);
        EXPECT_EQ(light.ambient[c], dominant.ambient[c]);
        EXPECT_EQ(light.harmonics[8][c], harmonics.coefficients[8][c]);
    }
    EXPECT_EQ(light.share, dominant.share);
    EXPECT_EQ(light.sees_place, 1);
    EXPECT_EQ(spherewalk_renderer_probe(renderer.get(), place, nullptr, nullptr, nullptr), SPHEREWALK_OK);
    const auto refused = [&](const std::string& part) {
        expectStatus(spherewalk_renderer_probe(renderer.get(), place, &wanted, &into, &light),
                     SPHEREWALK_INVALID_INPUT, part);
        wanted.width = 64;
        wanted.threads = wanted.photo_colours = 0;
    };
    for (const int width : {0, -64, 63, 8194}) {
        wanted.width = width;
        refused("even number");
    }
    wanted.width = 66;
    refused("the radiance of a probe");
    wanted.threads = -1;
    refused("A probe cannot be made by -1 threads");
    wanted.photo_colours = 2;
    refused("photo_colours");
    into.clipped.size_bytes -= 1;
    refused("the clipped of a probe");
    expectStatus(spherewalk_renderer_probe(renderer.get(), nullptr, nullptr, nullptr, nullptr),
                 SPHEREWALK_INVALID_INPUT, "place_m");
    const double nowhere[] = {0, HUGE_VAL, 0};
    expectStatus(spherewalk_renderer_probe(renderer.get(), nowhere, nullptr, nullptr, nullptr),
                 SPHEREWALK_INVALID_INPUT, "position");
}

TEST_F(CInterface, GivesOneLayerWithoutTheOthers) {
    std::vector<float> depth(pixels.size() / 3);
    std::vector<std::uint8_t> flags(pixels.size() / 3, 9);
    auto into = view();
    into.depth = {depth.data(), 4 * depth.size(), 4 * kWidth};
    ASSERT_EQ(spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, nullptr, &into, nullptr),
              SPHEREWALK_OK);
    EXPECT_GT(depth[depth.size() / 2], 0.5);
    into = view();
    into.flags = {flags.data(), flags.size(), kWidth};
    ASSERT_EQ(spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, nullptr, &into, nullptr),
              SPHEREWALK_OK);
    EXPECT_TRUE(std::none_of(flags.begin(), flags.end(), [](int flag) { return flag == 9; }));
    into = view();
    into.overlaid = {flags.data(), flags.size(), kWidth};
    ASSERT_EQ(spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, nullptr, &into, nullptr),
              SPHEREWALK_OK);
    EXPECT_EQ(flags, std::vector<std::uint8_t>(flags.size(), 0)); // no overlay covers anything
}

TEST_F(CInterface, ServesManyThreadsAtOnce) {
    ASSERT_EQ(render(kHere), SPHEREWALK_OK);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([this] {
            for (int frame = 0; frame < 20; ++frame) {
                std::vector<std::uint8_t> own(pixels.size());
                spherewalk_view view = ready(spherewalk_view_init);
                view.rgb = {own.data(), own.size(), std::uint64_t{3} * kWidth};
                EXPECT_EQ(
                    spherewalk_renderer_render(renderer.get(), camera.get(), &kHere, nullptr, &view, nullptr),
                    SPHEREWALK_OK);
                EXPECT_EQ(own, pixels);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    auto counters = ready(spherewalk_load_counters_init);
    ASSERT_EQ(spherewalk_renderer_get_counters(renderer.get(), &counters), SPHEREWALK_OK);
    EXPECT_EQ(counters.hits + counters.late, 81U);
    EXPECT_GT(counters.resident_bytes, 0U);
}

TEST_F(CInterface, TakesFramesAsTheLibrary) {
    const std::string yaml = "{exposure: {time_s: 0.02}, shutter: {line_delay_s: 2e-4}, "
                             "noise: {full_well_e: 2000, read_e: 5}, depth: {most_m: 1.9}}";
    const auto by = sensor(yaml);
    const auto stream = this->stream();
    std::vector<spherewalk_timed_pose> route{{1, kHere}, {1.1, kHere}};
    route[1].room_from_camera.x += 0.2;
    std::vector<float> depths(pixels.size() / 3);
    spherewalk_view into = view();
    into.depth = {depths.data(), 4 * depths.size(), 4 * static_cast<std::uint64_t>(kWidth)};
    ASSERT_EQ(
        spherewalk_stream_take(stream.get(), by.get(), route.data(), 2, 1.05, 3, nullptr, &into, nullptr),
        SPHEREWALK_OK)
        << spherewalk_last_error();
    const CameraModel model(CameraIntrinsics::pinhole(kWidth, kHeight, 1.2));
    const Renderer reference(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    ViewStream expected(reference, model);
    Sensor same(parseSensor(yaml, "y"), model);
    const auto rigid = [](const spherewalk_pose& p) {
        return Rigid3{Eigen::Quaterniond(p.qw, p.qx, p.qy, p.qz), {p.x, p.y, p.z}};
    };
    const std::vector<TimedPose> path{{1, rigid(route[0].room_from_camera)},
                                      {1.1, rigid(route[1].room_from_camera)}};
    View frame;
    same.take(
        [&](const Rigid3& pose, double timeS, bool isMain, View& made) {
            ViewOptions options;
            options.wantsDepth = isMain;
            expected.next(pose, timeS, options, made);
        },
        [&](double timeS) { return poseAt(path, timeS); }, 1.05, 3, frame);
    same.measureDepth(3, frame.depth);
    EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), frame.picture.values().begin()));
    EXPECT_TRUE(std::equal(depths.begin(), depths.end(), frame.depth.values().begin()));
    EXPECT_GT(std::count(depths.begin(), depths.end(), std::numeric_limits<float>::infinity()), 0);

    const auto fails = [&](std::uint64_t count, double timeS, const std::string& part) {
        expectStatus(spherewalk_stream_take(stream.get(), by.get(), route.data(), count, timeS, 3, nullptr,
                                            &into, nullptr),
                     SPHEREWALK_INVALID_INPUT, part);
    };
    fails(0, 1, "at least one pose");
    fails(2, test::kNan, "not a number");
    route[1].time_s = 1;
    fails(2, 1, "not later");
    spherewalk_sensor* none = nullptr;
    expectStatus(spherewalk_sensor_parse("x: 1", 4, camera.get(), &none), SPHEREWALK_INVALID_INPUT,
                 "x is unknown");
    EXPECT_EQ(none, nullptr);
}

TEST_F(CInterface, StreamsOutliveWhatTheyWereMadeFrom) {
    const auto stream = this->stream();
    dataset.reset();
    renderer.reset();
    camera.reset();
    const spherewalk_view into = view();
    auto report = ready(spherewalk_report_init);
    spherewalk_pose pose = kHere;
    for (int i = 0; i < 5; ++i) {
        pose.x = 0.2 * i;
        ASSERT_EQ(spherewalk_stream_next(stream.get(), &pose, 0.1 * i, nullptr, &into, &report),
                  SPHEREWALK_OK);
        ASSERT_EQ(spherewalk_stream_wait_for_prefetch(stream.get()), SPHEREWALK_OK);
    }
    EXPECT_EQ(report.photo, 1U);
    EXPECT_EQ(report.is_late, 0);
    auto counters = ready(spherewalk_stream_counters_init);
    ASSERT_EQ(spherewalk_stream_get_counters(stream.get(), &counters), SPHEREWALK_OK);
    EXPECT_EQ(counters.views, 5U);
}

namespace {

/// All values of an enumeration, by their names.
template <class Enum>
std::vector<Enum> allOf() {
    std::vector<Enum> values;
    for (int i = 0; name(static_cast<Enum>(i)) != "unknown"; ++i) {
        values.push_back(static_cast<Enum>(i));
    }
    EXPECT_FALSE(values.empty());
    return values;
}

} // namespace

// A value that the C++ interface gets, and the C one does not, fails here.
TEST_F(CInterface, HasANumberForEveryValue) {
    for (const SceneKind scene : allOf<SceneKind>()) {
        EXPECT_EQ(sceneOf(cScene(scene)), scene);
        EXPECT_EQ(spherewalk_scene_name(cScene(scene)), name(scene));
    }
    for (const Sampling sampling : allOf<Sampling>()) {
        EXPECT_EQ(samplingOf(cSampling(sampling)), sampling);
        EXPECT_EQ(spherewalk_sampling_name(cSampling(sampling)), name(sampling));
    }
    for (const ViewOrigin origin : allOf<ViewOrigin>()) {
        EXPECT_EQ(originOf(cOrigin(origin)), origin);
        EXPECT_EQ(spherewalk_origin_name(cOrigin(origin)), name(origin));
    }
    for (const LatePolicy policy : allOf<LatePolicy>()) {
        EXPECT_EQ(lateOf(cLate(policy)), policy);
        EXPECT_EQ(spherewalk_late_name(cLate(policy)), name(policy));
    }
    for (int kind = 0; kind <= static_cast<int>(ErrorKind::Internal); ++kind) {
        const auto value = static_cast<ErrorKind>(kind);
        EXPECT_EQ(spherewalk_status_name(cStatus(value)), name(value));
    }
    EXPECT_STREQ(spherewalk_status_name(SPHEREWALK_OK), "ok");
    for (const std::int32_t none : {-1, 99, INT32_MIN, INT32_MAX}) {
        EXPECT_STREQ(spherewalk_status_name(none), "unknown");
        EXPECT_STREQ(spherewalk_scene_name(none), "unknown");
        EXPECT_STREQ(spherewalk_sampling_name(none), "unknown");
        EXPECT_STREQ(spherewalk_origin_name(none), "unknown");
        EXPECT_STREQ(spherewalk_late_name(none), "unknown");
    }
}

} // namespace spherewalk::render
