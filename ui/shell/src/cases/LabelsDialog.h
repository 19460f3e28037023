#pragma once

#include <insonate/cases/LabelFile.h>

#include <QDialog>
#include <QImage>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;
class QVBoxLayout;

namespace insonate::ui {

/// Facts about labels whose computation takes a pass over all voxels.
struct LabelsPreview {
  QImage slice;                           ///< image of a slice with the labels, as labelPreview() returns it
  std::array<std::size_t, 256> voxels{};  ///< number of voxels by label
};

/// Computes the preview of labels on the grid of `ct`. May be used on any thread.
LabelsPreview labelsPreviewOf(const CtVolume& ct, const LabelReadResult& read);

/// Shows how the program understands the labels of a file or folder, with a slice of the CT, before the labels replace
/// the case's labels. The user can leave structures out, and states the side of vessels whose side is doubtful. If the
/// file does not say what its numbers mean, the dialog accepts the labels only after the user has stated that the
/// numbers are this program's numbers, or has chosen a file that names the numbers.
class LabelsDialog : public QDialog {
  Q_OBJECT

 public:
  /// `read` is used only in the constructor.
  LabelsDialog(const QString& fileName, const LabelReadResult& read, const LabelsPreview& preview, QWidget* parent);

  /// Returns the user's decisions that differ from those with which the labels were read.
  StructureChoices choices() const;
  /// Tells whether the program shall label the rest of the CT automatically.
  bool labelsRest() const;

 Q_SIGNALS:
  void namesRequested();  ///< emitted when the user wants to choose a file that names the numbers

 private:
  /// The controls of a structure.
  struct Row {
    std::string key;
    QTableWidgetItem* taken;
    bool wasTaken;
    QComboBox* side;  ///< null for a structure without a side
    int formerSide;   ///< entry of `side` for the side that the program has found
  };
  QTableWidget* makeTable(const LabelReadResult& read, const LabelsPreview& preview);
  Row makeRow(QTableWidget& table, int row, const ReadStructure& structure);
  void addUnnamed(QVBoxLayout& box);
  void enableReplace();

  std::vector<Row> rows_;
  QCheckBox* rest_;
  QCheckBox* areOurs_ = nullptr;  ///< check box with which the user states that the numbers are this program's; null
                                  ///< if the file names its structures
  QPushButton* replace_;
};

}  // namespace insonate::ui
