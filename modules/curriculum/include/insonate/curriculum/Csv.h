#pragma once

#include <insonate/core/Result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

struct CsvRow {
  int line = 1;  ///< line of the file on which the row begins
  std::vector<std::string> fields{};
};

/// Parses RFC 4180: quotes may hold separators, line breaks and doubled quotes. Also accepted: a byte order mark, any
/// line end, and semicolons or tabs instead of commas (the separator that is most frequent in the first line, outside
/// quotes). Empty lines are left out. Fails, with the line, if a quote is not closed, if text follows a closing quote,
/// or if the text is not UTF-8 or contains NUL.
Result<std::vector<CsvRow>> parseCsv(std::string_view text);

/// Writes RFC 4180 with CRLF. The text begins with a byte order mark: without it Excel reads UTF-8 in the computer's
/// old code page and shows umlauts wrong; LibreOffice, Moodle and parseCsv() remove it. A field that a spreadsheet
/// would take for a formula (because it begins with =, +, -, @ or a line break) gets an apostrophe before it, unless it
/// is a number. Spreadsheets that separate by semicolons or tabs may see such a field inside a field; each such place
/// gets an apostrophe, too.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

/// Shortest text that parses to the same value; "" for a missing or non-finite value.
std::string csvNumber(std::optional<double> value);

}  // namespace insonate
