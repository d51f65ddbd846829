// A loop over several threads; private to this floor.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace osculate {

/// Calls body(begin, end) for consecutive pieces of [0, count), `grain` long, in `threads` threads,
/// this one among them; which thread takes which piece is left to chance. Every thread asks
/// `isWanted` between its pieces, this one also while it waits for the others; once that says false
/// no further piece is begun. The first exception stops all and is thrown here.
inline void parallelFor(std::size_t count, std::size_t grain, int threads,
                        const std::function<void(std::size_t, std::size_t)>& body,
                        const std::function<bool()>& isWanted) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = false;
  std::mutex mutex;  // of the two below
  std::exception_ptr failure;
  std::size_t running = 0;
  std::condition_variable finished;
  const auto guarded = [&](const auto& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      stopped = true;
    }
  };
  const auto takePieces = [&] {
    while (!stopped) {
      const std::size_t begin = next.fetch_add(grain);
      if (begin >= count) return;
      body(begin, std::min(begin + grain, count));
      if (!isWanted()) stopped = true;
    }
  };
  const auto help = [&] {
    guarded(takePieces);
    const std::lock_guard lock(mutex);
    if (--running == 0) finished.notify_one();
  };
  const auto waitForOthers = [&] {
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, std::chrono::milliseconds(10), [&] { return running == 0; })) {
      lock.unlock();
      if (!isWanted()) stopped = true;
      lock.lock();
    }
  };
  const std::size_t pieces = (count + grain - 1) / grain;
  std::vector<std::jthread> others;
  running = std::max<std::size_t>(std::min(static_cast<std::size_t>(threads), pieces), 1) - 1;
  for (std::size_t i = running; i > 0; --i)
    others.emplace_back(help);
  guarded(takePieces);
  guarded(waitForOthers);
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace osculate
