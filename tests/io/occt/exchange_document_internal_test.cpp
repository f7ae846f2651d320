#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/body_shape.h"
#include "occt/exchange_document.h"

namespace dupin::occt {
namespace {

TEST(ExchangeDocument, refuses_what_is_no_sound_solid) {
  const TopoDS_Shape pipe = solid_of(bent_pipe()).shape;
  EXPECT_EQ(checked_solids(pipe, "pipe").size(), 1U);
  EXPECT_THROW((void)checked_solids(TopoDS_Shape(), "none"), Refusal);
  EXPECT_THROW((void)checked_solids(pipe.Reversed(), "inside out"), Refusal);
  const TopExp_Explorer faces(pipe, TopAbs_FACE);
  EXPECT_THROW((void)checked_solids(faces.Current(), "a face"), Refusal);
}

TEST(ExchangeDocument, holds_an_assembly_of_named_solids) {
  exchange::Model model;
  model.name = "both";
  model.labels.assign(8, {"part", {1, 2, 3}});
  const LabelledShape a = solid_of(bent_pipe()), b = solid_of(branch());
  const exchange::Written read =
      read_back(step_text(model, {{"first", a.shape}, {"second", b.shape}}, a.labels));
  ASSERT_EQ(read.solids.size(), 2U);
  EXPECT_EQ(read.solids[0].name, "first");
  EXPECT_EQ(read.solids[1].name, "second");
  EXPECT_NEAR(read.solids[0].volume, kBentVolume, 1e-4);
  EXPECT_LT(read.tolerance, 1e-5);
}

}  // namespace
}  // namespace dupin::occt
