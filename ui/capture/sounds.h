// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/verdict.h"

namespace spherewalk::ui {

/// How a verdict sounds, for an operator who looks at the cart and not at the screen.
class Sounds {
  public:
    virtual ~Sounds() = default;

    virtual void play(Verdict verdict) = 0;
    /// A second of the countdown.
    virtual void tick() = 0;
};

/// With the desktop's bell: once for good, twice for doubtful, three times for failed.
class BellSounds : public Sounds {
  public:
    void play(Verdict verdict) override;
    void tick() override;
};

} // namespace spherewalk::ui
