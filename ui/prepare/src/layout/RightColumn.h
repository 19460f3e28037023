#pragma once

#include <QSplitter>
#include <vector>

class QScrollArea;
class QSettings;
class QTabBar;
class QVBoxLayout;

namespace insonate::prepare {

class Section;

/// The column beside the slices: sections that are always shown at the top, two pages of sections, one of which is
/// shown, and a footer that is always visible.
class RightColumn : public QSplitter {
 public:
  enum class Place {
    Top,   ///< sections above both pages; each is hidden until setShown() shows it
    Case,  ///< the page about the case and its display
    Check  ///< the page about findings, difficulty and places
  };

  RightColumn();

  /// Adds a section below the earlier sections of the same place. `key` identifies the section in the settings.
  Section& addSection(Place place, const QString& key, const QString& title, QWidget* content);
  void setFoot(QWidget* foot);
  void setTips(const QString& casePage, const QString& checkPage);

  bool showsCheck() const;
  void showCheck(bool isShown);
  /// Shows or hides a section at Place::Top. A section that is shown is also expanded, and the column scrolls to its
  /// top.
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
