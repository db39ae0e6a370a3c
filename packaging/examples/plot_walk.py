#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders a walk through a scanned room, and plots what each view was made from and how far it can be trusted.

Cells begin with "# %%": run them one by one in an editor that knows them (Jupyter, VS Code, Spyder), or all at once:

    spherewalk-cli demo demo
    python3 plot_walk.py demo walk.png
"""

# %% Open what `spherewalk-cli demo` left, or your own dataset, camera and path
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np
import spherewalk

arguments = [word for word in sys.argv[1:] if not word.startswith("-")]  # a notebook's own are no concern of ours
demo = pathlib.Path(arguments[0] if arguments else "demo")
out = pathlib.Path(arguments[1] if len(arguments) > 1 else "walk.png")

dataset = spherewalk.Dataset.open(demo / "dataset")
camera = spherewalk.Camera.read(demo / "robot.yaml")
times, poses = spherewalk.read_tum(demo / "path.tum")  # of the optical frame

# %% Render the walk; what comes next is decoded ahead
renderer = spherewalk.Renderer(dataset)
stream = spherewalk.ViewStream(renderer, camera)
options = spherewalk.ViewOptions(depth=True)
views = [stream.next(pose, time, options) for time, pose in zip(times, poses)]
reports = [view.report for view in views]
print(f"{len(views)} views from {len({report.file for report in reports})} photos, "
      f"{np.median([report.render_ms for report in reports]):.1f} ms each (median)")

# %% The plan: walls, photos, and the path, coloured by how far the photo is from the camera
figure = plt.figure(figsize=(13, 8), constrained_layout=True)
grid = figure.add_gridspec(3, 4)
plan = figure.add_subplot(grid[:2, :2])
walls = np.vstack([dataset.outline, dataset.outline[:1]])
plan.plot(*walls.T, color="black", linewidth=2)
for obstacle in dataset.obstacles:
    plan.fill(*obstacle.T, color="0.85")
stood = np.array([photo.room_from_photo[:2, 3] for photo in dataset.photos])
plan.plot(*stood.T, "o", markerfacecolor="none", color="tab:gray", label="photos")
positions, ahead = poses[:, :2, 3], poses[:, :2, 2]  # the optical axis is the third column
offsets = np.array([report.offset_m for report in reports])
for position, report in zip(positions, reports):
    plan.plot(*np.array([position, stood[report.photo]]).T, color="tab:gray", linewidth=0.6, zorder=0)
dots = plan.quiver(*positions.T, *ahead.T, 100 * offsets, cmap="viridis_r", width=0.008)
figure.colorbar(dots, ax=plan, label="from the photo, cm", shrink=0.8)
plan.set(aspect="equal", xlabel="x, m", ylabel="y, m", title=dataset.name)
plan.legend(loc="upper right")

# %% Along the walk: how far things may be off their places, and how long a view took
line = figure.add_subplot(grid[2, :2])
line.plot(times, [report.parallax_px for report in reports], color="tab:blue")
line.set(xlabel="time, s", ylim=(0, None))
line.set_ylabel("in doubt, px", color="tab:blue")
cost = line.twinx()
cost.bar(times, [report.render_ms for report in reports], width=0.5 * np.median(np.diff(times)), color="tab:orange",
         alpha=0.5)
cost.set_ylabel("rendering, ms", color="tab:orange")

# %% Some views, and the depth that the scene model has for the last one
shown = np.linspace(0, len(views) - 1, 5).astype(int)
for cell, index in enumerate(shown):
    axes = figure.add_subplot(grid[cell // 2, 2 + cell % 2])
    axes.imshow(views[index].picture)
    axes.set_title(f"{times[index]:.1f} s, {100 * offsets[index]:.0f} cm from {reports[index].file}", fontsize=8)
    axes.axis("off")
axes = figure.add_subplot(grid[2, 3])
if views[-1].depth is not None:  # the scene model "none" has no depth
    depth = axes.imshow(views[-1].depth, cmap="magma_r")
    figure.colorbar(depth, ax=axes, label="m along the axis")
axes.set_title(f"depth, scene model {reports[-1].scene}", fontsize=8)
axes.axis("off")
figure.savefig(out, dpi=100)
print(f"Wrote {out}.")
