#include "scene/MovingDetail.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace insonate::views {
namespace {

TEST(MovingDetail, SlowPicturesGetFewerPixelsAndQuickOnesMore) {
  EXPECT_EQ(MovingDetail::nextStep(0, 50), 0);
  EXPECT_EQ(MovingDetail::nextStep(3, 50), 3) << "good enough is kept";
  EXPECT_EQ(MovingDetail::nextStep(3, 10), 2) << "back one at a time";
  EXPECT_EQ(MovingDetail::nextStep(0, 10), 0);
  EXPECT_EQ(MovingDetail::nextStep(MovingDetail::kSteps - 1, 5000), MovingDetail::kSteps - 1);
  // Four times too slow is half as many pixels along a side, at once.
  EXPECT_EQ(MovingDetail::shrinkOf(MovingDetail::nextStep(0, 200)), 2);
  for (int step = 0; step < MovingDetail::kSteps; ++step)
    EXPECT_GE(MovingDetail::nextStep(step, 100), std::min(step + 1, MovingDetail::kSteps - 1));
}

/// A white rectangle over the upper left quarter of the view, as seen with so many pixels.
double whiteShare(int step, bool moving, int x0, int y0, int x1, int y1) {
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(200, 160);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-100, 0, 0), plane->SetPoint1(0, 0, 0), plane->SetPoint2(-100, 80, 0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(80);
  window->Render();  // from its first image on, a window knows its size
  MovingDetail detail(step);
  struct Hooks {
    MovingDetail& detail;
    vtkRenderer& renderer;
    bool moving;
    void starts() { detail.starts(renderer, moving); }
    void ends() { detail.ends(renderer); }
  } hooks{detail, *renderer, moving};
  window->AddObserver(vtkCommand::StartEvent, &hooks, &Hooks::starts);
  renderer->AddObserver(vtkCommand::EndEvent, &hooks, &Hooks::ends);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(x0, y0, x1 - 1, y1 - 1, 1, pixels);
  double sum = 0;
  for (vtkIdType k = 0; k < pixels->GetNumberOfTuples(); ++k) sum += pixels->GetTuple(k)[0] / 255;
  detail.release(*window);
  return sum / double(pixels->GetNumberOfTuples());
}

TEST(MovingDetail, WhatIsEnlargedIsWhereItWas) {
  for (const int step : {0, 1, 3, 5, 7}) {
    // VTK counts rows from below.
    EXPECT_NEAR(whiteShare(step, true, 0, 80, 100, 160), 1, 0.06) << step;
    EXPECT_NEAR(whiteShare(step, true, 106, 0, 200, 160), 0, 1e-9) << step;
    EXPECT_NEAR(whiteShare(step, true, 0, 0, 100, 74), 0, 1e-9) << step;
  }
  EXPECT_EQ(whiteShare(7, false, 0, 80, 100, 160), 1) << "at rest nothing is enlarged";
}

}  // namespace
}  // namespace insonate::views
