// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/background_worker.h"

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

BackgroundWorker::BackgroundWorker(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

BackgroundWorker::~BackgroundWorker() {
    dropWaiting();
    m_thread.request_stop();
    m_thread.join();
}

void BackgroundWorker::post(const QString& key, Work work) {
    {
        const std::scoped_lock lock(m_mutex);
        std::erase_if(m_waiting, [&](const Item& item) { return item.key == key; });
        m_waiting.push_front({key, std::move(work)});
    }
    m_posted.notify_one();
}

void BackgroundWorker::hurry(const QString& key) {
    const std::scoped_lock lock(m_mutex);
    const auto found =
        std::find_if(m_waiting.begin(), m_waiting.end(), [&](const Item& item) { return item.key == key; });
    if (found != m_waiting.end()) {
        Item item = std::move(*found);
        m_waiting.erase(found);
        m_waiting.push_front(std::move(item));
    }
}

void BackgroundWorker::dropWaiting() {
    const std::scoped_lock lock(m_mutex);
    m_waiting.clear();
}

void BackgroundWorker::run(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (m_posted.wait(lock, stop, [this] { return !m_waiting.empty(); })) {
        const Item item = std::move(m_waiting.front());
        m_waiting.pop_front();
        lock.unlock();
        if (Deliver deliver = item.work()) {
            QMetaObject::invokeMethod(this, std::move(deliver), Qt::QueuedConnection);
        }
        lock.lock();
    }
}

} // namespace spherewalk::ui
