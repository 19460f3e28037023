#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/LabelColors.h>
#include <insonate/views/SceneView.h>

#include <QTimer>
#include <QWidget>
#include <map>
#include <memory>

class QCheckBox;
class QSettings;

namespace insonate::ui {

class ClippingControls;
class EyeControls;
class HistogramEditor;
class StructureList;
class ValueSlider;

/// Controls of a 3D view: skin transparency, structures, the CT with its transfer function, a clipping plane, stereo
/// and the head-coupled view. While the user moves a control, the view is drawn at a lower resolution. The panel is
/// narrow and long: put it into a QScrollArea. May be used only on the window's thread.
///
/// The panel uses SceneView::setStructuresChanged(), by which the scene notifies the panel of surfaces and of changes
/// of their appearance. A scene can therefore have only one panel.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  /// Location of the controls for visibility, color and opacity of structures, including the skin.
  enum class Structures {
    Here,
    Elsewhere,  ///< these controls are in another widget; this panel does not change structures
  };
  explicit ScenePanel(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr,
                      Structures structures = Structures::Here);
  ~ScenePanel() override;

  /// Sets the case whose histogram is shown; null: no case. The owner of the scene must call SceneView::setCase(). A
  /// structure for which the author of the case has chosen an appearance is drawn with this appearance until the next
  /// case is set. The user's choices for other structures do not change, except that a new patient is first shown with
  /// skin and without the CT volume. While the color-blind-safe colors are selected, the author's colors are not used.
  void setCase(std::shared_ptr<const PatientCase> patient);

  HistogramEditor& histogram() { return *histogram_; }

  views::ColorScheme colorScheme() const { return scheme_; }
  /// Applies a color scheme to all structures. With the default scheme, the colors of the case are used.
  void setColorScheme(views::ColorScheme scheme);
  /// Restores the appearance that the author of the case has chosen; without one, shows all structures with the colors
  /// of the scheme and the default opacities.
  void restoreDefaults();

  /// Stores all settings except the clipping plane, which applies to one patient only.
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  /// Emitted when a structure's color has changed in the scene, so that slices can follow.
  void colorsChanged();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildStructures();
  QWidget* buildCt();
  void refresh();
  void scrollToHistogram();
  /// Draws the scene at a lower resolution until nothing has changed for a moment.
  void live();
  struct Look {
    views::Color color;
    double opacity = 1;
    bool visible = true;
  };
  Look look(std::uint8_t label) const;
  void setLook(std::uint8_t label, const Look& look);
  views::Color caseColor(std::uint8_t label) const;
  void takeLooks();
  void showAnother();

  std::shared_ptr<views::SceneView> scene_;
  ValueSlider* skin_ = nullptr;
  StructureList* structures_ = nullptr;
  QCheckBox* safeColors_ = nullptr;
  QCheckBox* ct_ = nullptr;
  HistogramEditor* histogram_ = nullptr;
  ClippingControls* clipping_ = nullptr;
  EyeControls* eyes_ = nullptr;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const PatientCase> last_;  ///< the last case that was not null
  std::map<std::uint8_t, Look> own_;  ///< appearance that the user chose for structures that are now drawn with the
                                      ///< author's appearance
  views::ColorScheme scheme_ = views::ColorScheme::Default;
  bool structuresHere_ = true, refreshing_ = false, refreshDue_ = false;
  QTimer rest_;
};

}  // namespace insonate::ui
