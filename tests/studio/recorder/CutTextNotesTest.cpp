#include "studio/recorder/CutTextNotes.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(CutTextNotes, TellEachTextOnceInTheOrderInWhichTheyCame) {
  CutTextNotes notes;
  EXPECT_TRUE(notes.notes({1280, 720}).empty());
  for (const char* text : {"wide", "a long one", "wide"}) notes.see(text);
  const std::vector<std::string> told = notes.notes({1280, 720});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0],
            "in pictures of 1280 x 720 there is no room for all of the text \"wide\": its end is cut off; shorten it, "
            "or tell it in two captions");
  EXPECT_NE(told[1].find("\"a long one\""), std::string::npos);
}

TEST(CutTextNotes, TellNoMoreThanTheBeginningOfALongTextAndNoHalfLetters) {
  CutTextNotes notes;
  std::string dashes;
  for (int k = 0; k < 50; ++k) dashes += "\xe2\x80\x94";
  notes.see("a" + dashes);
  EXPECT_NE(notes.notes({1280, 720})[0].find("\"a" + dashes.substr(0, 57) + "...\""), std::string::npos);
}

}  // namespace
}  // namespace thinwall
