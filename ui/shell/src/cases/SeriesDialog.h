#pragma once

#include <insonate/cases/Import.h>

#include <QDialog>
#include <memory>
#include <optional>
#include <string>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class TaskBar;

/// The user's choices for an import.
struct ImportChoice {
  std::string uid;
  bool label = true;                   ///< true: label the case automatically
  std::optional<int> shift_HU{};       ///< value for shiftValues(), if a shift was offered and accepted
  bool saturate = false;               ///< true: import the series even if values exceed the range of a case
  std::shared_ptr<ImportedCt> read{};  ///< the series, if it was already read for the preview
};

/// Lets the user choose a series of a folder to import. The dialog lists the scanner's description of each series, its
/// date, size, spacing and warnings, and shows the middle slice of the selected series.
class SeriesDialog : public QDialog {
  Q_OBJECT

 public:
  SeriesDialog(const QString& path, std::shared_ptr<const SeriesListing> listing, QWidget* parent);

  ImportChoice choice() const;

 private:
  void fill();
  void setUpWidgets();
  void arrange();
  void showChosen();
  void preview();
  /// Shows data that become known only when the voxels are read.
  void showWhatWasRead();
  void showPicture();
  void refreshImport();
  const SeriesInfo& seriesAt(int row) const;
  const SeriesInfo& chosenSeries() const;
  std::optional<int> wantedShift() const;
  int likeliestRow() const;
  int chosenRow() const;
  void noPicture(const Error& error);

  QString path_;
  std::shared_ptr<const SeriesListing> listing_;
  ListingOverview overview_;  ///< row n of the table is the series overview_.shown[n]
  std::shared_ptr<ImportedCt> read_;
  QTableWidget* table_;
  QLabel *notes_, *picture_;
  QCheckBox *label_, *shift_, *saturate_;
  QPushButton* import_;
  TaskBar* tasks_;
};

}  // namespace insonate::ui
