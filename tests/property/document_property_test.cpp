#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/base/json.h"
#include "core/relight/setting.h"
#include "core/session/document_editor.h"
#include "core/session/session_file.h"
#include "tests/property/arbitrary.h"

namespace swaplight {
namespace {

using test::anyDocument;
using test::anyInt;

RC_GTEST_PROP(Properties, ASettingComesBackFromItsText, ()) {
  LightSetting setting = test::anyLightSetting(1);
  setting.solo = setting.mute = setting.ratioLock = false;  // are no part of it
  setting.role = Role::Other;
  setting.label = setting.group = "";
  LightSetting read;
  read.light = setting.light;
  applySetting(read, settingText(setting));
  RC_ASSERT(read == setting);
}

RC_GTEST_PROP(Properties, ARigComesBackFromJson, ()) {
  const Rig rig = test::anyRig();
  std::vector<std::string> warnings;
  RC_ASSERT(rigFromJson(Json::parse(jsonFromRig(rig).dump()), "rig", &warnings) == rig);
  RC_ASSERT(warnings.empty());
}

RC_GTEST_PROP(Properties, AnEditStackComesBackFromJson, ()) {
  const EditStack stack = test::anyEditStack();
  const Json json = Json::parse(jsonFromEditStack(stack).dump());
  std::vector<std::string> warnings;
  RC_ASSERT(editStackFromJson(json, stack.width, stack.height, "edits", &warnings) == stack);
  RC_ASSERT(warnings.empty());
}

RC_GTEST_PROP(Properties, ASessionComesBackFromJson, ()) {
  Session session;
  session.document = anyDocument();
  session.unknown = Json{{"written by a later version", anyInt(0, 9)}};
  const Json json = Json::parse(jsonFromSession(session, "/sets").dump());
  const Session read = sessionFromJson(json, "/sets", "any.swaplight");
  RC_ASSERT(read.document == session.document);
  RC_ASSERT(read.unknown == session.unknown);
  RC_ASSERT(read.warnings.size() == 1U);
}

RC_GTEST_PROP(Properties, UndoAfterAnyGestureIsAsIfNothingHadBeenDone, ()) {
  DocumentEditor editor;
  editor.reset(anyDocument(), "opened");
  for (int i = anyInt(0, 3); i > 0; --i) editor.edit("before", anyDocument());
  const Document before = editor.document();
  for (int i = anyInt(1, 4); i > 0; --i) editor.preview("a gesture", anyDocument());
  const Document after = editor.document();
  editor.commit();
  RC_PRE(!(after == before));
  editor.undo();
  RC_ASSERT(editor.document() == before);
  editor.redo();
  RC_ASSERT(editor.document() == after);
}

RC_GTEST_PROP(Properties, TheHistoryIsAListWithAPlaceInIt, ()) {
  Document document = anyDocument();
  History history(document);
  std::vector<Document> list = {document};
  size_t place = 0;
  for (int i = anyInt(0, 20); i > 0; --i) {
    switch (anyInt(0, 3)) {
      case 0:
        history.undo();
        place -= place > 0;
        break;
      case 1:
        history.redo();
        place += place + 1 < list.size();
        break;
      default:
        document.rig.ambient += 1;
        history.commit("step", document);
        list.resize(++place);
        list.push_back(document);
    }
    RC_ASSERT(history.document() == list[place]);
    RC_ASSERT(history.canUndo() == (place > 0));
    RC_ASSERT(history.canRedo() == (place + 1 < list.size()));
  }
}

}  // namespace
}  // namespace swaplight
