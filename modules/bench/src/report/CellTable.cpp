#include "report/CellTable.h"

#include <cmath>
#include <cstdio>

namespace insonate::bench {
namespace {

std::string line(const Cells& cells, const char* begin, const char* between, const char* end) {
  std::string text = begin;
  for (std::size_t i = 0; i < cells.size(); ++i) text += (i ? between : "") + cells[i];
  return text + end;
}

}  // namespace

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string csv(const std::vector<Cells>& rows) {
  std::string text;
  for (const Cells& row : rows) text += line(row, "", ",", "\n");
  return text;
}

std::string markdown(const std::vector<Cells>& rows) {
  std::string text = line(rows.front(), "| ", " | ", " |\n");
  text += line(Cells(rows.front().size(), "---"), "| ", " | ", " |\n");
  for (std::size_t i = 1; i < rows.size(); ++i) text += line(rows[i], "| ", " | ", " |\n");
  return text + "\n";
}

}  // namespace insonate::bench
