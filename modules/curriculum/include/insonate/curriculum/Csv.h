#pragma once

#include <insonate/core/Result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

struct CsvRow {
  int line = 1;  ///< where it begins in the file
  std::vector<std::string> fields{};
};

/// RFC 4180: quotes may hold separators, line breaks and doubled quotes. Also read: a byte order mark, any line end,
/// semicolons or tabs instead of commas (whichever the first line has most of, outside quotes). Empty lines are left
/// out. Fails where a quote is not closed or text follows one, the text is not UTF-8 or holds NUL, with the line.
Result<std::vector<CsvRow>> parseCsv(std::string_view text);

/// RFC 4180, with CRLF. A byte order mark begins it: without one Excel reads UTF-8 in the computer's old code page and
/// shows umlauts wrong; LibreOffice, Moodle and parseCsv() take it away. A field that a spreadsheet would take for a
/// formula (=, +, -, @ or a break in front) gets an apostrophe before it, unless it is a number; so does each place in
/// it where a spreadsheet that separates by semicolons or tabs would see one begin.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

/// Shortest text that parses to the same value; "" for a missing or non-finite value.
std::string csvNumber(std::optional<double> value);

}  // namespace insonate
