#include "monitoring/Metrics.h"

#include <QString>
#include <chrono>

namespace insonate::web {
namespace {

std::string numberText(double value) {
  return QString::number(value, 'g', 12).toStdString();
}

void addHead(std::string& text, const std::string& name, const std::string& kind, const std::string& help) {
  text += "# HELP " + name + " " + help + "\n# TYPE " + name + " " + kind + "\n";
}

}  // namespace

Metrics::Metrics()
    : start_s_(std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
                   .count()) {}

void Metrics::count(std::string_view method, std::string_view route, int status, double seconds) {
  const std::lock_guard lock(mutex_);
  ++requests_[{std::string(method), std::string(route), status}];
  Times& times = times_[std::string(route)];
  for (std::size_t i = 0; i < kBounds_s.size(); ++i)
    if (seconds <= kBounds_s[i]) ++times.upTo[i];
  ++times.count;
  times.sum_s += seconds;
}

void Metrics::countDatabaseFailures(std::int64_t failures) {
  const std::lock_guard lock(mutex_);
  databaseFailures_ += failures;
}

std::string Metrics::text() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  addHead(text, "insonate_start_time_seconds", "gauge", "Time at which the server was started, since 1970");
  text += "insonate_start_time_seconds " + std::to_string(start_s_) + "\n";
  addHead(text, "insonate_database_failures_total", "counter", "Failed accesses to the database");
  text += "insonate_database_failures_total " + std::to_string(databaseFailures_) + "\n";
  addHead(text, "insonate_requests_total", "counter", "Answered requests");
  for (const auto& [key, count] : requests_) {
    const auto& [method, route, status] = key;
    text += "insonate_requests_total{method=\"" + method + "\",route=\"" + route + "\",status=\"" +
            std::to_string(status) + "\"} " + std::to_string(count) + "\n";
  }
  addHead(text, "insonate_request_seconds", "histogram", "Time from a complete request to its answer");
  for (const auto& [route, times] : times_) {
    const std::string label = "{route=\"" + route + "\"";
    for (std::size_t i = 0; i < kBounds_s.size(); ++i)
      text += "insonate_request_seconds_bucket" + label + ",le=\"" + numberText(kBounds_s[i]) + "\"} " +
              std::to_string(times.upTo[i]) + "\n";
    text += "insonate_request_seconds_bucket" + label + ",le=\"+Inf\"} " + std::to_string(times.count) + "\n";
    text += "insonate_request_seconds_sum" + label + "} " + numberText(times.sum_s) + "\n";
    text += "insonate_request_seconds_count" + label + "} " + std::to_string(times.count) + "\n";
  }
  return text;
}

}  // namespace insonate::web
