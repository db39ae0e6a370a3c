// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spherewalk::python {

/// From here on, a spherewalk::Error that leaves a function of the module is raised as the exception that
/// spherewalk/_errors.py has for its kind, with its sentence.
void translateErrors();

} // namespace spherewalk::python
