#include "record/Block.h"
#include "record/Chain.h"
#include "record/HeaderText.h"
#include "record/RecordFile.h"
#include "record/SampleRing.h"
#include "record/SegmentCodec.h"

#include <insonate/core/Fingerprint.h>
#include <insonate/procedure/AttemptRecorder.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace insonate {

namespace fs = std::filesystem;
using record::BlockKind;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::int64_t kStretch_us = 1'000'000;
constexpr auto kWake = std::chrono::milliseconds(20);

}  // namespace

struct AttemptRecorder::State {
  State(fs::path target, record::RecordFile begun, record::ChainWriter links, const AttemptHeader& header,
        std::shared_ptr<AttemptListener> also)
      : path(std::move(target)),
        follower(std::move(also)),
        file(std::move(begun)),
        chain(std::move(links)),
        settings(header.settings) {
    if (!follower) pass.emplace(header.picture, !header.vessels.empty());
  }

  void run();
  void drain();
  void add(const AttemptSample& sample);
  void add(const AttemptEvent& event);
  void add(const SettingsChange& change);
  void close();
  void append(record::Bytes block);
  Result<MetricValues> finish(AttemptStatus status);

  const fs::path path;
  const std::shared_ptr<AttemptListener> follower;  ///< or null
  record::SampleRing ring;

  // Runs on the recorder's thread; after it has ended, in finish().
  record::RecordFile file;
  record::ChainWriter chain;
  std::optional<AttemptMetrics> pass;  ///< none if the follower computes them
  RecordingSegment open;
  Clock::time_point opened;
  std::int64_t lastSample_us = 0, end_us = 0;
  std::uint32_t segmentCount = 0, changes = 0;
  std::string settings;
  bool refused = false;

  mutable std::mutex mutex;  ///< guards the following members
  std::condition_variable wake;
  bool stopping = false;
  std::vector<AttemptEvent> notes;
  std::vector<SettingsChange> changed;
  MetricValues values;
  std::string error;

  std::thread thread;
};

void AttemptRecorder::State::run() {
  for (bool last = false; !last;) {
    {
      std::unique_lock lock(mutex);
      wake.wait_for(lock, kWake, [&] { return stopping; });
      last = stopping;
    }
    drain();
  }
  close();
}

void AttemptRecorder::State::drain() {
  std::vector<AttemptEvent> noted;
  std::vector<SettingsChange> anew;
  {
    const std::lock_guard lock(mutex);
    noted.swap(notes), anew.swap(changed);
  }
  for (const SettingsChange& change : anew) add(change);
  ring.drain([&](const record::RingEntry& entry) { std::visit([&](const auto& what) { add(what); }, entry); });
  for (const AttemptEvent& event : noted) add(event);
  if (Clock::now() - opened > std::chrono::microseconds(kStretch_us)) close();
  const MetricValues now = follower ? follower->metrics() : pass->values();
  const std::lock_guard lock(mutex);
  values = now;
}

void AttemptRecorder::State::add(const AttemptSample& sample) {
  if (sample.time_us < lastSample_us) return;
  if (!open.samples.empty() && sample.time_us - open.samples.front().time_us >= kStretch_us) close();
  if (open.samples.empty() && open.events.empty()) opened = Clock::now();
  open.samples.push_back(quantize(sample));
  lastSample_us = sample.time_us, end_us = std::max(end_us, lastSample_us);
  const AttemptSample kept = dequantize(open.samples.back());
  if (follower)
    follower->add(kept);
  else
    pass->add(kept);
}

void AttemptRecorder::State::add(const AttemptEvent& event) {
  if (open.samples.empty() && open.events.empty()) opened = Clock::now();
  open.events.push_back({static_cast<std::uint32_t>(open.samples.size()), event});
  end_us = std::max(end_us, event.time_us);
  if (follower)
    follower->add(event);
  else
    pass->add(event);
}

void AttemptRecorder::State::add(const SettingsChange& change) {
  if (change.settings == settings) return;
  settings = change.settings;
  ++changes;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(settings.data());
  append(record::packed(BlockKind::Settings, change.time_us, change.time_us, {bytes, settings.size()}));
}

void AttemptRecorder::State::close() {
  if (open.samples.empty() && open.events.empty()) return;
  const std::int64_t first_us = open.samples.empty() ? lastSample_us : open.samples.front().time_us;
  open.samplesLost = ring.takeLost();
  append(record::packed(BlockKind::RecordingSegment, first_us, end_us, record::encoded(open)));
  open.samples.clear(), open.events.clear();
  ++segmentCount;
}

void AttemptRecorder::State::append(record::Bytes block) {
  if (refused) return;
  const auto written = file.append(chain.linked(std::move(block)));
  if (written) return;
  refused = true;
  const std::lock_guard lock(mutex);
  error = written.error().message;
}

Result<MetricValues> AttemptRecorder::State::finish(AttemptStatus status) {
  {
    const std::lock_guard lock(mutex);
    stopping = true;
  }
  wake.notify_all();
  thread.join();
  record::Bytes end;
  end.push_back(static_cast<std::uint8_t>(status));
  record::put(end, segmentCount), record::put(end, changes);
  append(record::packed(BlockKind::End, end_us, end_us, end));
  if (refused) return fail(error);
  std::error_code failure;
  if (fs::exists(path, failure))
    return fail(path.string() + " was created by another program meanwhile; the recording was saved as " +
                partialFile(path).string() + ".");
  fs::rename(partialFile(path), path, failure);
  if (failure)
    return fail("The recording could not be named " + path.string() + " (" + failure.message() + "); it is kept as " +
                partialFile(path).string() + ".");
  return values;
}

fs::path AttemptRecorder::partialFile(const fs::path& file) {
  return fs::path(file) += ".part";
}

Result<fs::path> AttemptRecorder::recover(const fs::path& partial) {
  const fs::path file = fs::path(partial).replace_extension();
  if (partialFile(file) != partial) return fail(partial.string() + " is no unfinished recording.");
  if (record::RecordFile::isOpen(partial)) return fail("Another program is writing " + partial.string() + ".");
  std::error_code failure;
  if (fs::exists(file, failure))
    return fail(file.string() + " exists; rename it, so that " + partial.string() + " can have its name.");
  fs::rename(partial, file, failure);
  if (failure) return fail(partial.string() + " cannot be renamed (" + failure.message() + ").");
  return file;
}

Result<std::unique_ptr<AttemptRecorder>> AttemptRecorder::start(const fs::path& path, const AttemptHeader& header,
                                                                std::shared_ptr<AttemptListener> follower,
                                                                const std::optional<RecordKey>& key) {
  std::error_code failure;
  if (fs::exists(path, failure))
    return fail(path.string() + " exists, and recordings are never overwritten. Choose another name.");
  auto file = record::RecordFile::make(partialFile(path));
  if (!file) return tl::unexpected(file.error());
  AttemptHeader hashed = header;
  if (!header.settings.empty()) {
    Fingerprint fingerprint;
    fingerprint.add(header.settings);
    hashed.settingsHash = fingerprint.text();
  }
  const std::string text = record::textOf(hashed);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  record::ChainWriter chain(key);
  if (auto ok = file->append(chain.linked(record::packed(BlockKind::Header, 0, 0, {bytes, text.size()}))); !ok)
    return tl::unexpected(ok.error());
  auto state = std::make_unique<State>(path, std::move(*file), std::move(chain), header, std::move(follower));
  state->thread = std::thread([s = state.get()] { s->run(); });
  return std::unique_ptr<AttemptRecorder>(new AttemptRecorder(std::move(state)));
}

AttemptRecorder::AttemptRecorder(std::unique_ptr<State> state) : state_(std::move(state)) {}

AttemptRecorder::~AttemptRecorder() {
  if (state_->thread.joinable()) (void)state_->finish(AttemptStatus::Abandoned);
}

void AttemptRecorder::record(const AttemptSample& sample) noexcept {
  state_->ring.put(sample);
}

void AttemptRecorder::record(const AttemptEvent& event) noexcept {
  state_->ring.put(event);
}

std::size_t AttemptRecorder::freeSlots() const noexcept {
  return state_->ring.room();
}

void AttemptRecorder::recordFromOtherThread(const AttemptEvent& event) {
  const std::lock_guard lock(state_->mutex);
  state_->notes.push_back(event);
}

void AttemptRecorder::recordFromOtherThread(const SettingsChange& change) {
  const std::lock_guard lock(state_->mutex);
  state_->changed.push_back(change);
}

MetricValues AttemptRecorder::metrics() const {
  const std::lock_guard lock(state_->mutex);
  return state_->values;
}

std::string AttemptRecorder::error() const {
  const std::lock_guard lock(state_->mutex);
  return state_->error;
}

Result<MetricValues> AttemptRecorder::finish(AttemptStatus status) {
  return state_->finish(status);
}

}  // namespace insonate
