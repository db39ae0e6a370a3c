// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/survey_store.h"

#include <mutex>

namespace spherewalk::jobs {

/// A survey's store that two threads use in turn. Owner: the store must outlive it.
class SharedStore {
  public:
    explicit SharedStore(store::SurveyStore& store) : m_store(store) {}

    /// What the call returns for the store, while no other thread has it. Never nested.
    template <class Call>
    auto use(Call&& call) {
        const std::scoped_lock lock(m_mutex);
        return call(m_store);
    }

  private:
    store::SurveyStore& m_store;
    std::mutex m_mutex;
};

} // namespace spherewalk::jobs
