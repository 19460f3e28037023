#include "HidDevice.h"

#include <array>
#include <utility>

namespace insonate::haptics {
namespace {

constexpr std::size_t kMaxReport = 256;
/// A force device that has sent nothing for this time counts as absent.
constexpr std::int64_t kSilence_ns = 250'000'000;
/// Time for which zeros are sent after the last push; then the device's own watchdog takes over.
constexpr std::int64_t kFarewell_ns = 1'000'000'000;

/// Maximum wait of a read: a force device must be asked in time for its next force, a pedal before a foot notices a
/// delay.
int wait_msOf(DeviceKind kind) {
  return kind == DeviceKind::kForce ? 1 : kind == DeviceKind::kMotion ? 4 : 20;
}

}  // namespace

HidDevice::HidDevice(DeviceInfo info, std::shared_ptr<const DeviceTable> table, std::shared_ptr<EventQueue> events,
                     std::shared_ptr<ReportRecorder> recorder)
    : info_(std::move(info)),
      table_(std::move(table)),
      events_(std::move(events)),
      recorder_(std::move(recorder)),
      decoder_(*table_),
      maker_(*table_) {}

HidDevice::~HidDevice() {
  close();
}

std::string HidDevice::error() const {
  const std::lock_guard lock(textMutex_);
  return error_;
}

DeviceCounters HidDevice::counters() const noexcept {
  return {reports_.load(), forces_.load(), refused_.load(), lateForces_.load()};
}

bool HidDevice::pollState(DeviceState& state) noexcept {
  const auto latest = states_.takeLatest();
  if (latest) state = *latest;
  return latest.has_value();
}

void HidDevice::push(const Force& force) noexcept {
  if (table_->output) pushed_.post({force, monotonic_ns()});
}

void HidDevice::enter(DevicePhase phase, std::string text, bool error) {
  {
    const std::lock_guard lock(textMutex_);
    error_ = error ? text : std::string();
  }
  phase_.store(phase, std::memory_order_release);
  events_->put({0, info_.id, phase, error, std::move(text)});
}

void HidDevice::opening(const std::string& path) {
  path_ = path;
  // A device that cannot be opened is tried each second, but reported once.
  if (phase() != DevicePhase::kFailed) enter(DevicePhase::kOpening, info_.name + " is being opened.", false);
}

void HidDevice::cannotOpen(const std::string& why) {
  if (phase() == DevicePhase::kFailed && error() == why) return;
  enter(DevicePhase::kFailed, why, true);
}

void HidDevice::missing() {
  const DevicePhase now = phase();
  if (now == DevicePhase::kFailed || now == DevicePhase::kOpening)
    enter(DevicePhase::kAbsent, info_.name + " was unplugged.", false);
}

void HidDevice::attach(std::unique_ptr<HidHandle> handle) {
  if (thread_.joinable()) thread_.join();
  handle_ = std::move(handle);
  decoder_.reset();
  maker_.reset();
  // Forces from before unplugging must not reach the hand that holds the device now.
  pushed_.takeLatest();
  states_.takeLatest();
  latest_.reset();
  reported_ns_ = sent_ns_ = 0;
  stop_ = false;
  attached_.store(true, std::memory_order_release);
  enter(DevicePhase::kReady, info_.name + " is open.", false);
  thread_ = std::thread([this] { serve(); });
}

void HidDevice::close() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
  if (phase() != DevicePhase::kAbsent) enter(DevicePhase::kAbsent, info_.name + " was released.", false);
}

void HidDevice::serve() {
  bool there = true;
  while (there && !stop_.load(std::memory_order_relaxed)) {
    std::int64_t now_ns = 0;
    there = readAll(now_ns);
    if (there) there = sendForce(now_ns);
    checkSilence(now_ns);
    reportRefused(now_ns);
  }
  if (there && latest_) write({});
  handle_.reset();
  if (!there) enter(DevicePhase::kLost, info_.name + " was unplugged. It resumes when it is plugged in.", true);
  attached_.store(false, std::memory_order_release);
}

bool HidDevice::readAll(std::int64_t& now_ns) {
  std::array<std::uint8_t, kMaxReport> report;
  int bytes = handle_->read(report, wait_msOf(info_.kind));
  now_ns = monotonic_ns();
  bool news = false;
  // Queued reports are old: only the latest position counts. The number is limited, in case a device sends without
  // pause.
  for (int i = 0; bytes > 0 && i < 64; ++i) {
    receive(std::span(report).first(static_cast<std::size_t>(bytes)), now_ns);
    news = true;
    bytes = handle_->read(report, 0);
  }
  if (calibrate_.exchange(false, std::memory_order_relaxed)) maker_.calibrate(decoder_.reading());
  // A 3D mouse that sends nothing is at rest: its last position is current.
  const bool rests = info_.kind == DeviceKind::kMotion && phase() == DevicePhase::kStreaming;
  if (reported_ns_ != 0 && (news || rests)) postState(now_ns);
  return bytes >= 0;
}

void HidDevice::receive(std::span<const std::uint8_t> report, std::int64_t now_ns) {
  if (recorder_ && recorder_->isRunning()) recorder_->record(info_.id, table_->name, true, report);
  if (decoder_.decode(report) != ReportOutcome::kDecoded) {
    refused_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  reports_.fetch_add(1, std::memory_order_relaxed);
  reported_ns_ = now_ns;
  if (phase() != DevicePhase::kStreaming) enter(DevicePhase::kStreaming, info_.name + " sends its position.", false);
}

void HidDevice::postState(std::int64_t now_ns) noexcept {
  states_.post(maker_.make(decoder_.reading(), reported_ns_, now_ns));
}

bool HidDevice::sendForce(std::int64_t now_ns) {
  if (!table_->output) return true;
  const auto pushed = pushed_.takeLatest();
  if (pushed) latest_ = pushed;
  if (!latest_) return true;
  const std::int64_t age_ns = now_ns - latest_->time_ns;
  if (age_ns > kFarewell_ns) {
    latest_.reset();
    return true;
  }
  const auto period_ns = static_cast<std::int64_t>(1e9 / info_.limits.rate_Hz);
  if (now_ns - sent_ns_ < period_ns / 2) return true;
  // Without positions no force: a silent device is no longer at the place for which the force was computed.
  const bool alive = age_ns < kForceLife_ns && reported_ns_ != 0 && now_ns - reported_ns_ < kForceLife_ns;
  sent_ns_ = now_ns;
  return write(alive ? limitedForce(info_.limits, latest_->force) : Force{});
}

bool HidDevice::write(const Force& force) {
  std::array<std::uint8_t, kMaxReport> report;
  DeviceOutput output = maker_.outputFor(force, decoder_.reading());
  output.sequence = ++sequence_;
  const std::size_t bytes = encodeReport(*table_->output, output, report);
  const std::int64_t begin_ns = monotonic_ns();
  writing_ns_.store(begin_ns, std::memory_order_release);
  const bool sent = handle_->write(std::span(report).first(bytes));
  writing_ns_.store(0, std::memory_order_release);
  if (monotonic_ns() - begin_ns > static_cast<std::int64_t>(2e9 / info_.limits.rate_Hz))
    lateForces_.fetch_add(1, std::memory_order_relaxed);
  if (sent) forces_.fetch_add(1, std::memory_order_relaxed);
  if (sent && recorder_ && recorder_->isRunning())
    recorder_->record(info_.id, table_->name, false, std::span(report).first(bytes));
  return sent;
}

void HidDevice::checkSilence(std::int64_t now_ns) {
  if (info_.kind != DeviceKind::kForce || phase() != DevicePhase::kStreaming) return;
  if (now_ns - reported_ns_ > kSilence_ns)
    enter(DevicePhase::kLost, info_.name + " no longer sends its position. Check its power and its cable.", true);
}

void HidDevice::reportRefused(std::int64_t now_ns) {
  const std::uint64_t refused = refused_.load(std::memory_order_relaxed);
  if (refused == toldRefused_ || now_ns - told_ns_ < 1'000'000'000) return;
  const std::uint64_t more = refused - toldRefused_;
  toldRefused_ = refused;
  told_ns_ = now_ns;
  // Mice and pedals also send reports about their battery; this is a fault only if they send nothing else.
  if (info_.kind != DeviceKind::kForce && reports_.load(std::memory_order_relaxed) > 0) return;
  events_->put({0, info_.id, phase(), true,
                info_.name + ": " + std::to_string(more) + (more == 1 ? " report was" : " reports were") +
                    " ignored, because length or kind does not match the device table."});
}

void HidDevice::watch(std::int64_t now_ns) {
  const std::int64_t since_ns = writing_ns_.load(std::memory_order_acquire);
  if (since_ns == 0 || now_ns - since_ns < kForceLife_ns || phase() != DevicePhase::kStreaming) return;
  enter(DevicePhase::kLost, info_.name + " no longer accepts forces. Unplug it and plug it in again.", true);
}

}  // namespace insonate::haptics
