#pragma once

#include <QSplitter>
#include <vector>

class QScrollArea;
class QSettings;
class QTabBar;
class QVBoxLayout;

namespace insonate::prepare {

class Section;

/// The column beside the slices: two pages of sections, of which one is shown, sections above both, and a foot that is
/// always visible.
class RightColumn : public QSplitter {
 public:
  enum class Place {
    Top,   ///< above both pages; hidden until setShown()
    Case,  ///< the page about the case and its display
    Check  ///< the page about findings, difficulty and places
  };

  RightColumn();

  /// Adds a section below the earlier ones of its place. `key` identifies it in the settings.
  Section& addSection(Place place, const QString& key, const QString& title, QWidget* content);
  void setFoot(QWidget* foot);
  void setTips(const QString& casePage, const QString& checkPage);

  bool showsCheck() const;
  void showCheck(bool isShown);
  /// Shows or hides a section of the top, expands it, and scrolls to the top of the column.
  void setShown(Section& section, bool isShown);
  /// Scrolls to a widget once the layout is known.
  void scrollTo(QWidget& widget);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  void showPage();

  QTabBar* tabs_;
  QScrollArea* scroll_;
  QVBoxLayout *top_, *case_, *check_;
  QWidget *casePage_, *checkPage_;
  std::vector<Section*> all_;  ///< sections of both pages
};

}  // namespace insonate::prepare
