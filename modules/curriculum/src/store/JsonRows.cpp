#include "store/JsonRows.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <utility>

namespace insonate::store {
namespace {

nlohmann::ordered_json jsonOfValue(const std::string_view column, const Row& row, std::size_t at) {
  if (row.isNull(at)) return nullptr;
  // Columns that are stored as text and exported as JSON.
  if (column == "metrics" || column == "answers") return nlohmann::ordered_json::parse(row.text(at), nullptr, false);
  switch (row.value(at).type()) {
    case QVariant::Int:
    case QVariant::LongLong:
      return row.number(at);
    case QVariant::Double:
      return *row.real(at);
    default:
      return row.text(at);
  }
}

}  // namespace

nlohmann::ordered_json jsonRows(const std::vector<const char*>& columns, const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry;
    for (std::size_t i = 0; i < columns.size(); ++i) entry[columns[i]] = jsonOfValue(columns[i], row, i);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace insonate::store
