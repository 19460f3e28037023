#pragma once

class QTableWidget;

namespace insonate::ui {

/// A table whose rows are chosen whole, one at a time, and not edited: a list of attempts. Columns keep their widths
/// but those that are stretched afterwards.
void makeRowTable(QTableWidget& table, int row_px);

}  // namespace insonate::ui
