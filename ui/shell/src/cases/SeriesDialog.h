#pragma once

#include <insonate/cases/Import.h>

#include <QDialog>
#include <memory>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class TaskBar;

/// Which of the series in a folder to import: modality, size, spacing, warnings, and the middle slice of the chosen
/// one.
class SeriesDialog : public QDialog {
  Q_OBJECT

 public:
  SeriesDialog(const QString& path, std::shared_ptr<const SeriesListing> listing, QWidget* parent);

  QString chosenUid() const;
  bool labelsWanted() const;
  /// The chosen series, where it was read for the preview; null where it was not.
  std::shared_ptr<ImportedCt> readAlready() const { return read_; }

 private:
  void fill();
  void arrange();
  void showChosen();
  void preview();
  int likeliestRow() const;
  int chosenRow() const;
  void noPicture(const Error& error);

  QString path_;
  std::shared_ptr<const SeriesListing> listing_;
  std::shared_ptr<ImportedCt> read_;
  QTableWidget* table_;
  QLabel *notes_, *picture_;
  QCheckBox* label_;
  QPushButton* import_;
  TaskBar* tasks_;
};

}  // namespace insonate::ui
