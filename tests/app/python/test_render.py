# SPDX-License-Identifier: GPL-3.0-or-later
import gc
import json
import shutil

import numpy as np
import pytest
import spherewalk
from conftest import BODY_POSE, DEMO, cli, pixels
from spherewalk import Camera, Dataset, PixelFlag, Renderer, ViewOptions


@pytest.mark.parametrize("scene", ["auto", "none", "sphere"])
@pytest.mark.parametrize("sampling", ["footprint", "nearest", "bicubic", "best", "auto"])
def test_the_command_line_gives_the_same_pixels_and_report(renderer, camera, tmp_path, scene, sampling):
    report = cli("view", DEMO / "dataset", "--camera", DEMO / "robot.yaml", "--frame", "body", "--pose",
                 " ".join(map(str, BODY_POSE)), "--scene", scene, "--sampling", sampling, "--out", tmp_path / "v.png")
    view = renderer.render(camera, BODY_POSE, ViewOptions(scene=scene, sampling=sampling), frame="body")
    assert view.picture.shape == (480, 640, 3) and view.picture.dtype == np.uint8
    assert np.array_equal(view.picture, pixels(tmp_path / "v.png"))
    got = view.report
    assert (got.file, got.scene, got.sampling, got.origin) == (
        report["photo"], report["scene"], report["sampling"], report["origin"])
    assert (got.offset_m, got.parallax_px, got.trust) == (report["offset_m"], report["parallax_px"], report["trust"])
    assert (got.outside, got.sees_place, got.seen_share) == (report["outside"], report["sees_place"], report["seen_share"])
    assert renderer.render(camera, BODY_POSE, frame="body").report.verified


def test_a_pose_is_the_same_in_all_its_forms(renderer, small):
    body = renderer.render(small, BODY_POSE, frame="body").picture
    matrix = spherewalk.pose_matrix(BODY_POSE, frame="body")
    assert np.array_equal(matrix, [[0, 0, 1, 2.5], [-1, 0, 0, 2], [0, -1, 0, 1.2], [0, 0, 0, 1]])
    assert np.array_equal(renderer.render(small, matrix).picture, body)
    assert np.array_equal(renderer.render(small, matrix.tolist()).picture, body)
    assert np.array_equal(renderer.render(small, [2.5, 2, 1.2, -0.5, 0.5, -0.5, 0.5]).picture, body)
    assert np.array_equal(renderer.render(small, np.asfortranarray(matrix)).picture, body)


def test_arrays_share_the_views_memory_and_outlive_it(renderer, small):
    view = renderer.render(small, BODY_POSE, frame="body")
    picture = view.picture
    assert np.shares_memory(picture, view.picture) and picture.flags.writeable and picture.flags.c_contiguous
    kept = picture.copy()
    del view
    gc.collect()
    others = [renderer.render(small, BODY_POSE) for _ in range(8)]  # would take the memory, were it free
    assert np.array_equal(picture, kept) and len(others) == 8


def test_depth_and_trust_are_there_when_they_are_wanted(renderer, small):
    plain = renderer.render(small, BODY_POSE, frame="body")
    assert (plain.depth, plain.trust, plain.error_px, plain.flags, plain.overlaid) == (None,) * 5
    view = renderer.render(small, BODY_POSE, ViewOptions(depth=True, trust=True), frame="body")
    assert np.array_equal(view.picture, plain.picture)
    assert view.depth.shape == view.error_px.shape == view.flags.shape == view.trust.shape == (48, 64)
    assert view.depth.dtype == view.error_px.dtype == view.trust.dtype == np.float32
    assert (view.depth > 0).all() and np.allclose(view.trust, 1 / (1 + view.error_px))
    at_photo = spherewalk.pose_matrix([*renderer_photo_position(renderer, small), 0, 0, 0, 1], frame="body")
    # What is left at a photo is the uncertainty of its own pose.
    assert renderer.render(small, at_photo, ViewOptions(trust=True)).trust.min() > 0.8


def renderer_photo_position(renderer, camera):
    """Of the photo that is nearest to the middle of the room."""
    dataset = Dataset.open(DEMO / "dataset")
    nearest = dataset.nearest_photo(BODY_POSE[:3])
    assert renderer.render(camera, BODY_POSE).report.photo == nearest
    return dataset.photos[nearest].room_from_photo[:3, 3]


def test_flags_have_the_library_s_values(renderer, small):
    assert {flag.name: flag.value for flag in PixelFlag} == spherewalk._core.pixel_flags
    down = ViewOptions(trust=True)
    flags = renderer.render(small, [2.5, 2, 1.2, 1, 0, 0, 0], down).flags  # the optical axis points at the floor
    assert (flags & PixelFlag.POLE).any()


def test_many_views_are_the_same_as_one_by_one(renderer, small):
    turns = np.linspace(0, 2 * np.pi, 9)
    poses = [[2.5, 2, 1.2, 0, 0, np.sin(a / 2), np.cos(a / 2)] for a in turns]
    for threads in (0, 1, 3):
        views = renderer.render_many(small, poses, ViewOptions(threads=threads, depth=True), frame="body")
        assert len(views) == 9
        for pose, view in zip(poses, views):
            assert np.array_equal(view.picture, renderer.render(small, pose, frame="body").picture)
            assert view.depth is not None
    assert renderer.render_many(small, np.zeros((0, 4, 4))) == []


def test_a_photo_can_be_left_out(renderer, small):
    nearest = renderer.render(small, BODY_POSE).report.photo
    assert renderer.render(small, BODY_POSE, ViewOptions(without=nearest)).report.photo != nearest


def test_colour_correction_can_be_switched_off(renderer, small, tmp_path):
    shutil.copytree(DEMO / "dataset", tmp_path / "d")
    description = json.loads((tmp_path / "d/dataset.json").read_text())
    straight = [i / 16 for i in range(17)]
    description["colour_correction"] = {"matrix": [[0, 0, 1], [0, 1, 0], [1, 0, 0]], "curves": [straight] * 3}
    (tmp_path / "d/dataset.json").write_text(json.dumps(description))
    dataset = Dataset.open(tmp_path / "d", verify="hashes")
    corrected = Renderer(dataset)
    own = renderer.render(small, BODY_POSE).picture.astype(int)
    assert dataset.has_colour_correction
    assert np.abs(corrected.render(small, BODY_POSE).picture - own[..., ::-1]).max() <= 2  # red and blue change places
    assert np.array_equal(corrected.render(small, BODY_POSE, ViewOptions(correct_colour=False)).picture, own)


def test_a_dataset_says_what_is_in_it(dataset):
    description = json.loads((DEMO / "dataset/dataset.json").read_text())
    assert dataset.id == description["id"] and dataset.name == description["name"]
    assert dataset.folder == str(DEMO / "dataset")
    assert [photo.file for photo in dataset.photos] == [photo["file"] for photo in description["photos"]]
    assert dataset.photos[0].width == 2 * dataset.photos[0].height == 1024
    assert dataset.photos[0].rotation_source == "aligned"
    assert dataset.scenes == ["none", "sphere"] and not dataset.has_colour_correction
    assert dataset.outline.shape == (4, 2) and dataset.ceiling_m > 2
    assert set(dataset.cameras) == {camera["name"] for camera in description["suggested_cameras"]}


def test_cameras_come_from_everywhere(camera, tmp_path):
    assert camera == Camera.pinhole(640, 480, np.radians(69))
    assert camera == Camera(640, 480, camera.K) and camera != Camera(640, 480, camera.K * [[2], [2], [1]])
    distorted = Camera(640, 480, camera.K, [-0.2, 0.05, 0.001, -0.001, 0], "plumb_bob")
    (tmp_path / "c.yaml").write_text(distorted.to_yaml("robot"))
    again = Camera.read(tmp_path / "c.yaml")
    assert again == distorted and again.lens == "plumb_bob" and list(again.distortion) == list(distorted.distortion)
    for lens in (camera, distorted, Camera(640, 480, camera.K, np.zeros(4), lens="equidistant")):
        at = np.stack(np.meshgrid(np.arange(0, 640, 80.0), np.arange(0, 480, 80.0)), axis=-1)
        rays = lens.rays(at)
        assert rays.shape == (6, 8, 3) and np.allclose(np.linalg.norm(rays, axis=-1), 1)
        assert np.allclose(lens.project(3 * rays), at, atol=1e-6)
    assert np.isnan(camera.project([0, 0, -1])).all()


def test_a_rig_has_cameras_and_their_places(camera, tmp_path):
    (tmp_path / "c.yaml").write_text(camera.to_yaml("robot"))
    (tmp_path / "rig.yaml").write_text(
        "axes: body\ncameras:\n"
        "  - {name: left, camera_info: c.yaml, rig_from_camera: [0, 0.06, 0, 0, 0, 0, 1]}\n"
        "  - {name: right, camera_info: c.yaml}\n"
    )
    rig = spherewalk.read_rig(tmp_path / "rig.yaml")
    assert list(rig) == ["left", "right"]
    left, rig_from_left = rig["left"]
    assert left == camera
    assert np.allclose(rig_from_left @ [0, 0, 1, 1], [1, 0.06, 0, 1])  # it looks along the rig's x
    assert rig["right"] == (camera, None)
    with pytest.raises(ValueError, match="no entry|cameras"):
        (tmp_path / "c.yaml").write_text("3")
        spherewalk.read_rig(tmp_path / "c.yaml")


def test_the_light_at_a_place(renderer, tmp_path):
    probe = renderer.light_probe([2.5, 2.0, 1.2], width=64)
    assert probe.radiance.shape == (32, 64, 3) and probe.radiance.dtype == np.float32
    assert probe.clipped.shape == (32, 64) and probe.clipped.dtype == np.uint8
    assert (probe.radiance >= 0).all()
    assert 0 <= probe.clipped_share <= 1 and 0 <= probe.recovered_share <= 1
    dominant = probe.dominant
    assert abs(np.linalg.norm(dominant["towards"]) - 1) < 1e-9 and 0 <= dominant["share"] <= 1
    towards, irradiance = probe.lights(32)
    assert towards.shape == irradiance.shape == (32, 3)
    flux = probe.harmonics[0] * np.sqrt(4 * np.pi)
    assert np.allclose(irradiance.sum(axis=0), flux, rtol=1e-3)
    probe.write(tmp_path / "light.hdr")
    assert (tmp_path / "light.hdr").read_bytes().startswith(b"#?RADIANCE\n")
    for place in ([1, 2], [[1, 2, 3]], [1, 2, np.nan]):
        with pytest.raises(spherewalk.InvalidInputError):
            renderer.light_probe(place)
    with pytest.raises(spherewalk.InvalidInputError, match="even number"):
        renderer.light_probe([2.5, 2.0, 1.2], width=15)
