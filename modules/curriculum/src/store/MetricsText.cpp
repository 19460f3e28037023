#include "store/MetricsText.h"

#include <nlohmann/json.hpp>

namespace insonate::store {
namespace {

using nlohmann::json;

/// Parses metrics as a stream: the page of a class has 2000 attempts with 26 metrics each, and building a JSON tree
/// first takes twice as long.
class MetricsReader final : public nlohmann::json_sax<json> {
 public:
  std::vector<MetricFact> metrics;

  bool start_array(std::size_t) override {
    if (++depth_ == 2) metrics.emplace_back();
    field_ = 0;
    return depth_ <= 2;
  }
  bool end_array() override { return depth_-- != 2 || field_ == kFields; }
  bool string(std::string& text) override {
    if (!isNext(0)) return false;
    metrics.back().id = std::move(text);
    return true;
  }
  bool number_integer(std::int64_t number) override { return whole(number); }
  bool number_unsigned(std::uint64_t number) override { return whole(static_cast<std::int64_t>(number)); }
  bool number_float(double number, const std::string&) override { return value(number); }
  bool null() override { return isNext(2); }
  bool boolean(bool) override { return false; }
  bool binary(json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return false; }
  bool key(std::string&) override { return false; }
  bool end_object() override { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  static constexpr int kFields = 3;

  bool isNext(int field) { return depth_ == 2 && field_++ == field; }
  bool whole(std::int64_t number) {
    if (field_ != 1) return value(static_cast<double>(number));
    metrics.back().version = static_cast<int>(number);
    return isNext(1);
  }
  bool value(double number) {
    if (!isNext(2)) return false;
    metrics.back().value = number;
    return true;
  }

  int depth_ = 0, field_ = 0;
};

}  // namespace

std::string metricsText(const std::vector<MetricFact>& metrics) {
  json all = json::array();
  for (const MetricFact& metric : metrics)
    all.push_back({metric.id, metric.version, metric.value ? json(*metric.value) : json()});
  return all.dump();
}

std::vector<MetricFact> metricsOf(const std::string& text) {
  MetricsReader reader;
  if (!json::sax_parse(text, &reader)) return {};
  return std::move(reader.metrics);
}

}  // namespace insonate::store
