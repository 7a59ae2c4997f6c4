#pragma once

namespace swaplight {

// Glyphs of Google's Material Icons (Apache-2.0; Debian's fonts-material-design-icons-iconfont) as UTF-8,
// with the font's own names.
#define SWAPLIGHT_ICONS(X)                                    \
  X(kIconOpen, "\xee\x8b\x88")       /* folder_open */        \
  X(kIconFolder, "\xee\x8b\x87")     /* folder */             \
  X(kIconFile, "\xee\x89\x8d")       /* insert_drive_file */  \
  X(kIconImage, "\xee\x8f\xb4")      /* image */              \
  X(kIconSave, "\xee\x85\xa1")       /* save */               \
  X(kIconExport, "\xee\x8b\x86")     /* file_upload */        \
  X(kIconUndo, "\xee\x85\xa6")       /* undo */               \
  X(kIconRedo, "\xee\x85\x9a")       /* redo */               \
  X(kIconHistory, "\xee\xa2\x89")    /* history */            \
  X(kIconFit, "\xee\x8f\x82")        /* crop_free */          \
  X(kIconPicker, "\xee\x8e\xb8")     /* colorize */           \
  X(kIconBrush, "\xee\x8e\xae")      /* brush */              \
  X(kIconPan, "\xee\xa4\xa5")        /* pan_tool */           \
  X(kIconCompare, "\xee\x8e\xb9")    /* compare */            \
  X(kIconPhoto, "\xee\x90\x90")      /* photo */              \
  X(kIconGallery, "\xee\x90\x93")    /* photo_library */      \
  X(kIconLight, "\xee\xa4\x8f")      /* lightbulb_outline */  \
  X(kIconTune, "\xee\x90\xa9")       /* tune */               \
  X(kIconReset, "\xee\x81\x82")      /* replay */             \
  X(kIconClose, "\xee\x97\x8d")      /* close */              \
  X(kIconCheck, "\xee\x97\x8a")      /* check */              \
  X(kIconAdd, "\xee\x85\x85")        /* add */                \
  X(kIconMore, "\xee\x97\x94")       /* more_vert */          \
  X(kIconDown, "\xee\x97\x8f")       /* expand_more */        \
  X(kIconUp, "\xee\x97\x8e")         /* expand_less */        \
  X(kIconRight, "\xee\x97\x8c")      /* chevron_right */      \
  X(kIconParent, "\xee\x97\x98")     /* arrow_upward */       \
  X(kIconHome, "\xee\xa2\x8a")       /* home */               \
  X(kIconLink, "\xee\x85\x97")       /* link */               \
  X(kIconInfo, "\xee\xa2\x8e")       /* info */               \
  X(kIconWarning, "\xee\x80\x82")    /* warning */            \
  X(kIconError, "\xee\x80\x80")      /* error */              \
  X(kIconHelp, "\xee\xa2\x87")       /* help */               \
  X(kIconSearch, "\xee\xa2\xb6")     /* search */             \
  X(kIconScopes, "\xee\x9b\xa1")     /* show_chart */         \
  X(kIconExposure, "\xee\x8f\x8a")   /* exposure */           \
  X(kIconPalette, "\xee\x90\x8a")    /* palette */            \
  X(kIconCopy, "\xee\x85\x8d")       /* content_copy */       \
  X(kIconPaste, "\xee\x85\x8f")      /* content_paste */      \
  X(kIconVisible, "\xee\xa3\xb4")    /* visibility */         \
  X(kIconFlag, "\xee\x85\x93")       /* flag */               \
  X(kIconPower, "\xee\xa2\xac")      /* power_settings_new */ \
  X(kIconSwap, "\xee\xa3\x94")       /* swap_horiz */         \
  X(kIconLayers, "\xee\x94\xbb")     /* layers */             \
  X(kIconStar, "\xee\xa0\xb8")       /* star */               \
  X(kIconStarBorder, "\xee\xa0\xba") /* star_border */        \
  X(kIconKeyboard, "\xee\x8c\x92")   /* keyboard */

#define SWAPLIGHT_DECLARE(name, utf8) inline constexpr const char* name = utf8;
SWAPLIGHT_ICONS(SWAPLIGHT_DECLARE)
#undef SWAPLIGHT_DECLARE

/// All of them in one text: what the font atlas has to hold.
#define SWAPLIGHT_TEXT(name, utf8) utf8
inline constexpr const char* kAllIcons = SWAPLIGHT_ICONS(SWAPLIGHT_TEXT);
#undef SWAPLIGHT_TEXT

}  // namespace swaplight
