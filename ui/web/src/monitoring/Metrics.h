#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <tuple>

namespace insonate::web {

/// Counts requests since the server was started, by the route of their page. Addresses, people and queries are not
/// recorded. May be used on any thread.
class Metrics {
 public:
  Metrics();

  /// Counts an answered request. `method` and `route` must have only few different values, since each pair makes a
  /// line.
  void count(std::string_view method, std::string_view route, int status, double seconds);
  void countDatabaseFailures(std::int64_t failures);

  /// Returns all counts in Prometheus' text format 0.0.4.
  std::string text() const;

 private:
  static constexpr std::array kBounds_s{0.01, 0.05, 0.1, 0.5, 1.0, 5.0};
  struct Times {
    std::array<std::int64_t, kBounds_s.size()> upTo{};  ///< for each bound: number of requests whose time was at most
                                                        ///< the bound
    std::int64_t count = 0;
    double sum_s = 0;
  };

  mutable std::mutex mutex_;
  std::int64_t start_s_;
  std::map<std::tuple<std::string, std::string, int>, std::int64_t> requests_;
  std::map<std::string, Times> times_;
  std::int64_t databaseFailures_ = 0;
};

}  // namespace insonate::web
