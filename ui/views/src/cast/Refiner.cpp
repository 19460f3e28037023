#include "Refiner.h"

#include <insonate/core/ThreadPriority.h>

#include <algorithm>
#include <utility>

namespace insonate::views {
namespace {

/// Number of rows that a thread takes at a time.
constexpr int kRows = 2;

}  // namespace

Refiner::Refiner(std::function<void()> news) : news_(std::move(news)) {
  const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1U, 16U);
  for (unsigned k = 0; k < count; ++k) threads_.emplace_back([this] { run(); });
}

Refiner::~Refiner() {
  rest();
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Refiner::prepare(std::shared_ptr<const PatientCase> patient) {
  {
    const std::lock_guard lock(mutex_);
    if (patient == prepared_) return;
    prepared_ = unprepared_ = std::move(patient);
  }
  changed_.notify_one();
}

std::shared_ptr<const CastVolume> Refiner::volume() const {
  const std::lock_guard lock(mutex_);
  return volume_;
}

void Refiner::want(int eye, CastTask task) {
  auto work = std::make_shared<Work>();
  work->picture = std::make_shared<CastPicture>();
  work->picture->task = std::move(task);
  const CastTask& kept = work->picture->task;
  work->picture->rgba.resize(std::size_t(4) * kept.across * kept.up);
  work->caster = std::make_unique<RayCaster>(kept);
  {
    const std::lock_guard lock(mutex_);
    if (works_[std::size_t(eye)]) works_[std::size_t(eye)]->left = true;
    works_[std::size_t(eye)] = std::move(work);
  }
  changed_.notify_all();
}

void Refiner::rest() {
  const std::lock_guard lock(mutex_);
  for (auto& work : works_)
    if (const auto old = std::exchange(work, nullptr)) old->left = true;
}

std::shared_ptr<const CastPicture> Refiner::picture(int eye) const {
  const std::lock_guard lock(mutex_);
  return pictures_[std::size_t(eye)];
}

bool Refiner::makes(int eye, const CastTask& task) const {
  const std::lock_guard lock(mutex_);
  const auto& work = works_[std::size_t(eye)];
  return work && work->picture->task.showsAs(task);
}

int Refiner::eyeInWork() const {
  for (int eye = 0; eye < kEyes; ++eye)
    if (const auto& work = works_[std::size_t(eye)]; work && work->next < work->picture->task.up) return eye;
  return -1;
}

void Refiner::run() {
  lowerThreadPriority();  // live images have precedence
  std::unique_lock lock(mutex_);
  while (!ends_) {
    if (auto patient = std::exchange(unprepared_, nullptr)) {
      lock.unlock();
      auto made = makeCastVolume(std::move(patient));
      lock.lock();
      if (made->patient != prepared_) continue;
      volume_ = std::move(made);
      lock.unlock();
      news_();
      lock.lock();
    } else if (const int eye = eyeInWork(); eye >= 0) {
      castNextRays(lock, eye);
    } else {
      changed_.wait(lock, [this] { return ends_ || unprepared_ || eyeInWork() >= 0; });
    }
  }
}

void Refiner::castNextRays(std::unique_lock<std::mutex>& lock, int eye) {
  const std::shared_ptr<Work> work = works_[std::size_t(eye)];
  CastPicture& picture = *work->picture;
  const int first = work->next, end = std::min(first + kRows, picture.task.up);
  work->next = end;
  lock.unlock();
  for (int row = first; row < end && !work->left; ++row)
    work->caster->castRow(row, picture.rgba.data() + std::size_t(4) * row * picture.task.across);
  lock.lock();
  work->done += end - first;
  if (work->done < picture.task.up || work->left) return;
  pictures_[std::size_t(eye)] = work->picture;
  works_[std::size_t(eye)] = nullptr;
  lock.unlock();
  news_();
  lock.lock();
}

}  // namespace insonate::views
