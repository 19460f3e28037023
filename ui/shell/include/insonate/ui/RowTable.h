#pragma once

class QTableWidget;

namespace insonate::ui {

/// Makes a table read-only, with one whole row selected at a time. Columns keep their widths unless the caller
/// stretches them afterwards.
void makeRowTable(QTableWidget& table, int row_px);

}  // namespace insonate::ui
