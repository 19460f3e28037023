#pragma once

#include <insonate/segmentation/LabelEdit.h>

#include <QObject>
#include <cstdint>
#include <vector>

namespace insonate::prepare {

class CaseMeasuring;
class LabelSession;
class Notice;
class OpenCase;
class TermsEditor;

/// The structures of the table, and the one that is selected.
class StructureList : public QObject {
  Q_OBJECT

 public:
  StructureList(OpenCase& openCase, const CaseMeasuring& measuring, LabelSession& labelling, TermsEditor& terms,
                Notice& notice, QObject* parent);

  /// Structures that occur or were added, in the table's order; empty before they are counted.
  const std::vector<std::uint8_t>& labels() const { return labels_; }
  std::uint8_t selected() const { return selected_; }
  void select(std::uint8_t label);
  /// Selects the next or previous structure of the table.
  void selectNext(int step);
  /// Lists a structure that no voxel has yet, and selects it. One of the author's own can be undone.
  void add(std::uint8_t label);
  /// Changes all its voxels to soft tissue; an own structure without voxels is removed.
  void removeVoxels(std::uint8_t label);
  /// Moves a listed structure to its next state, and says so.
  void toNextState(std::uint8_t label);

 Q_SIGNALS:
  void changed();
  void selectedChanged();

 private:
  void refresh();
  bool isListed(std::uint8_t label) const;

  OpenCase& openCase_;
  const CaseMeasuring& measuring_;
  LabelSession& labelling_;
  TermsEditor& terms_;
  Notice& notice_;
  std::vector<std::uint8_t> labels_;
  LabelSet added_;  ///< labels that are listed before they are counted
  std::uint8_t selected_ = 0;
};

}  // namespace insonate::prepare
