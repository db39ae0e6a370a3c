// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mujoco_example {

/// An OpenGL context that needs no display, current on the thread that made it as long as it lives.
class HeadlessGl {
  public:
    /// Errors: std::runtime_error where EGL has no such context.
    HeadlessGl();
    ~HeadlessGl();
    HeadlessGl(const HeadlessGl&) = delete;
    HeadlessGl& operator=(const HeadlessGl&) = delete;

  private:
    void* m_display = nullptr;
    void* m_context = nullptr;
};

} // namespace mujoco_example
