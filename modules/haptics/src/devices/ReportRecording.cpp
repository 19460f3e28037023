#include "EventQueue.h"

#include <insonate/haptics/ReportRecording.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <sstream>

namespace insonate {
namespace {

constexpr std::string_view kHeading = "insonate device reports 1";
/// Some minutes of two devices, in case the disk hangs.
constexpr std::size_t kMaxPending = 32U << 20;

/// Names are single words in the file.
std::string word(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') c = '_';
  return result.empty() ? "_" : result;
}

bool readHex(const std::string& text, std::vector<std::uint8_t>& bytes) {
  if (text.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    std::uint8_t byte = 0;
    const char* end = text.data() + i + 2;
    if (std::from_chars(text.data() + i, end, byte, 16).ptr != end) return false;
    bytes.push_back(byte);
  }
  return true;
}

}  // namespace

ReportRecorder::~ReportRecorder() {
  stop();
}

Result<void> ReportRecorder::start(const std::filesystem::path& file) {
  if (auto whole = stop(); !whole) return whole;
  path_ = file;
  file_.open(file, std::ios::trunc);
  if (!file_) {
    file_.clear();
    return fail("The recording " + file.string() + " cannot be written. Check its folder and your permissions.");
  }
  file_ << kHeading << '\n';
  begin_ns_ = haptics::monotonic_ns();
  lost_ = false;
  running_.store(true, std::memory_order_release);
  writer_ = std::jthread([this](const std::stop_token& stop) {
    for (; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(20))) flush();
  });
  return {};
}

Result<void> ReportRecorder::stop() {
  if (!running_.exchange(false, std::memory_order_acq_rel)) return {};
  writer_ = {};
  flush();
  file_.close();
  const bool whole = static_cast<bool>(file_) && !lost_;
  file_.clear();
  if (!whole) return fail("The recording " + path_.string() + " is not complete: is the disk full?");
  return {};
}

void ReportRecorder::flush() {
  std::string lines;
  {
    const std::lock_guard lock(mutex_);
    lines.swap(pending_);
  }
  file_ << lines;
}

void ReportRecorder::record(const std::string& device, std::string_view table, bool in,
                            std::span<const std::uint8_t> report) {
  static constexpr char kDigits[] = "0123456789abcdef";
  char time[32];
  const std::lock_guard lock(mutex_);
  if (!isRunning()) return;
  if (pending_.size() > kMaxPending) {
    lost_ = true;
    return;
  }
  // Under the lock, so that times increase from line to line.
  std::snprintf(time, sizeof time, "%.6f ", static_cast<double>(haptics::monotonic_ns() - begin_ns_) * 1e-9);
  pending_ += time + word(device) + ' ' + word(table) + (in ? " in " : " out ");
  for (const std::uint8_t byte : report) pending_ += {kDigits[byte >> 4], kDigits[byte & 15]};
  pending_ += report.empty() ? "-\n" : "\n";
}

Result<std::vector<RecordedReport>> readRecording(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!stream || !std::getline(stream, line)) return fail("The recording " + file.string() + " cannot be read.");
  if (line != kHeading)
    return fail(file.string() + " is not a recording of device reports: it begins with another line.");
  std::vector<RecordedReport> reports;
  for (int number = 2; std::getline(stream, line); ++number) {
    std::istringstream words(line);
    RecordedReport report;
    std::string way, hex, more;
    const bool read = static_cast<bool>(words >> report.time_s >> report.device >> report.table >> way >> hex);
    const bool right = read && !(words >> more) && (way == "in" || way == "out") &&
                       report.time_s >= (reports.empty() ? 0 : reports.back().time_s) &&
                       (hex == "-" || readHex(hex, report.bytes));
    if (!right) return fail(file.string() + ", line " + std::to_string(number) + " is not a report.");
    report.in = way == "in";
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace insonate
