#pragma once

#include <insonate/cases/LabelFile.h>

#include <QDialog>
#include <QImage>

class QCheckBox;
class QPushButton;
class QVBoxLayout;

namespace insonate::ui {

/// Shows how the labels of a file are understood, with a slice of the CT, before they replace the case's labels. If the
/// file does not say what its numbers mean, they are accepted only once the user states that they are this program's
/// numbers, or names them by another file.
class LabelsDialog : public QDialog {
  Q_OBJECT

 public:
  /// `ct` and `read` have the same grid; both are only used while the dialog is made.
  LabelsDialog(const QString& fileName, const CtVolume& ct, const LabelReadResult& read, QWidget* parent);

 Q_SIGNALS:
  void namesWanted();  ///< emitted when the user wants to choose a file that names the numbers

 private:
  void addUnnamed(QVBoxLayout& box);

  QCheckBox* areOurs_ = nullptr;  ///< null if the file names its structures
  QPushButton* replace_;
};

/// Returns the slice perpendicular to k with the most labeled voxels, with the labels in their colors over the CT; at
/// most `side` pixels wide and high. The patient's left is on the right if i or j runs along that direction. For any
/// thread.
QImage labelPreview(const CtVolume& ct, const LabelReadResult& read, int side);

}  // namespace insonate::ui
