#pragma once

class QTableWidget;

namespace insonate::ui {

/// Makes a read-only table in which one whole row is selected at a time: a list of attempts. Columns keep their widths
/// except those that are stretched afterwards.
void makeRowTable(QTableWidget& table, int row_px);

}  // namespace insonate::ui
