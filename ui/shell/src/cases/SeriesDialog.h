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

/// Choices for an import.
struct ImportChoice {
  std::string uid;
  bool label = true;                   ///< automatically
  std::optional<int> shift_HU{};       ///< for shiftValues(), where it was offered and wanted
  std::shared_ptr<ImportedCt> read{};  ///< the series, where it was read for the preview
};

/// Chooses one of the series in a folder to import: modality, size, spacing, warnings, and the middle slice of the
/// selected one.
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
  /// Shows facts that need the voxels, once they are read.
  void showWhatWasRead();
  void showPicture();
  std::string chosenUid() const;
  std::optional<int> wantedShift() const;
  int likeliestRow() const;
  int chosenRow() const;
  void noPicture(const Error& error);

  QString path_;
  std::shared_ptr<const SeriesListing> listing_;
  std::shared_ptr<ImportedCt> read_;
  QTableWidget* table_;
  QLabel *notes_, *picture_;
  QCheckBox *label_, *shift_;
  QPushButton* import_;
  TaskBar* tasks_;
};

}  // namespace insonate::ui
