<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>spherewalk::ui::AlignPresenter</name>
    <message numerus="yes">
        <source>Move %n photo(s) to other stations</source>
        <translation>
            <numerusform>Move %n photo to another station</numerusform>
            <numerusform>Move %n photos to other stations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) came since, or were left out: align again.</source>
        <translation>
            <numerusform>%n photo came since, or was left out: align again.</numerusform>
            <numerusform>%n photos came since, or were left out: align again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Aligned %n photo(s) in %1.</source>
        <translation>
            <numerusform>Aligned %n photo in %1.</numerusform>
            <numerusform>Aligned %n photos in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Moved %n photo(s); align again to be sure.</source>
        <translation>
            <numerusform>Moved %n photo; align again to be sure.</numerusform>
            <numerusform>Moved %n photos; align again to be sure.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Alignment of %n photo(s): %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>Alignment of %n photo: %1 good, %2 doubtful, %3 failed.</numerusform>
            <numerusform>Alignment of %n photos: %1 good, %2 doubtful, %3 failed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With what the checks found, %n photo(s) are to be looked at in Review.</source>
        <translation>
            <numerusform>With what the checks found, %n photo is to be looked at in Review.</numerusform>
            <numerusform>With what the checks found, %n photos are to be looked at in Review.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraFinder</name>
    <message numerus="yes">
        <source>%n camera(s) found</source>
        <translation>
            <numerusform>%n camera found</numerusform>
            <numerusform>%n cameras found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraPanel</name>
    <message numerus="yes">
        <source>%n photo(s)</source>
        <translation>
            <numerusform>%n photo</numerusform>
            <numerusform>%n photos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureMode</name>
    <message numerus="yes">
        <source>Look at %n in Review (R)</source>
        <translation>
            <numerusform>Look at %n in Review (R)</numerusform>
            <numerusform>Look at %n in Review (R)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Take %n again (T)</source>
        <translation>
            <numerusform>Take %n again (T)</numerusform>
            <numerusform>Take %n again (T)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::DeskRemote</name>
    <message numerus="yes">
        <source>%n photo(s) left</source>
        <translation>
            <numerusform>%n photo left</numerusform>
            <numerusform>%n photos left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportMode</name>
    <message numerus="yes">
        <source>%1: %n photo(s), %2, in %3.</source>
        <translation>
            <numerusform>%1: %n photo, %2, in %3.</numerusform>
            <numerusform>%1: %n photos, %2, in %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s), about %1 and %2; %3 are free.</source>
        <translation>
            <numerusform>%n photo, about %1 and %2; %3 are free.</numerusform>
            <numerusform>%n photos, about %1 and %2; %3 are free.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) are doubtful or failed, and nobody has decided.</source>
        <translation>
            <numerusform>%n photo is doubtful or failed, and nobody has decided.</numerusform>
            <numerusform>%n photos are doubtful or failed, and nobody has decided.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>in %n photo</numerusform>
            <numerusform>in %n photos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n private region(s) %1 will be blurred.</source>
        <translation>
            <numerusform>%n private region %1 will be blurred.</numerusform>
            <numerusform>%n private regions %1 will be blurred.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportPresenter</name>
    <message numerus="yes">
        <source>Exported %n photo(s) to %1: %2.</source>
        <translation>
            <numerusform>Exported %n photo to %1: %2.</numerusform>
            <numerusform>Exported %n photos to %1: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FaceSearchBar</name>
    <message numerus="yes">
        <source>&amp;Search %n photo(s) for faces</source>
        <translation>
            <numerusform>&amp;Search %n photo for faces</numerusform>
            <numerusform>&amp;Search %n photos for faces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyModel</name>
    <message numerus="yes">
        <source>%1: %n photo(s), %2</source>
        <translation>
            <numerusform>%1: %n photo, %2</numerusform>
            <numerusform>%1: %n photos, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyPresenter</name>
    <message numerus="yes">
        <source>This survey has %n photo(s). Take a block of 5 x 5 at the finest step that you would use (3 x 3 at least), and ask then.</source>
        <translation>
            <numerusform>This survey has %n photo. Take a block of 5 x 5 at the finest step that you would use (3 x 3 at least), and ask then.</numerusform>
            <numerusform>This survey has %n photos. Take a block of 5 x 5 at the finest step that you would use (3 x 3 at least), and ask then.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1
Found in %2: %n photo(s), %L3 cm apart.</source>
        <translation>
            <numerusform>%1
Found in %2: %n photo, %L3 cm apart.</numerusform>
            <numerusform>%1
Found in %2: %n photos, %L3 cm apart.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MainWindow</name>
    <message numerus="yes">
        <source>%n task(s)</source>
        <translation>
            <numerusform>%n task</numerusform>
            <numerusform>%n tasks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) imported, %1 were there already.</source>
        <translation>
            <numerusform>%n photo imported, %1 were there already.</numerusform>
            <numerusform>%n photos imported, %1 were there already.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PagePresenter</name>
    <message numerus="yes">
        <source>%1: %n photo(s), %2. Distances can be measured in %3 of them. Share the whole folder.</source>
        <translation>
            <numerusform>%1: %n photo, %2. Distances can be measured in %3 of them. Share the whole folder.</numerusform>
            <numerusform>%1: %n photos, %2. Distances can be measured in %3 of them. Share the whole folder.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhotoReviewer</name>
    <message numerus="yes">
        <source>Accept %n photo(s)</source>
        <translation>
            <numerusform>Accept %n photo</numerusform>
            <numerusform>Accept %n photos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reject %n photo(s)</source>
        <translation>
            <numerusform>Reject %n photo</numerusform>
            <numerusform>Reject %n photos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reopen %n photo(s)</source>
        <translation>
            <numerusform>Reopen %n photo</numerusform>
            <numerusform>Reopen %n photos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanPanel</name>
    <message numerus="yes">
        <source>%n stop(s)</source>
        <translation>
            <numerusform>%n stop</numerusform>
            <numerusform>%n stops</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanWords</name>
    <message numerus="yes">
        <source>%n station(s)</source>
        <translation>
            <numerusform>%n station</numerusform>
            <numerusform>%n stations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s)</source>
        <translation>
            <numerusform>%n rail</numerusform>
            <numerusform>%n rails</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) by hand</source>
        <translation>
            <numerusform>%n photo by hand</numerusform>
            <numerusform>%n photos by hand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewMode</name>
    <message numerus="yes">
        <source>%1: %n photo(s)</source>
        <translation>
            <numerusform>%1: %n photo</numerusform>
            <numerusform>%1: %n photos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>● %n pose(s)</source>
        <translation>
            <numerusform>● %n pose</numerusform>
            <numerusform>● %n poses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) in the dataset</source>
        <translation>
            <numerusform>%n photo in the dataset</numerusform>
            <numerusform>%n photos in the dataset</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), without depth.</source>
        <translation>
            <numerusform>%1: %n photo, without depth.</numerusform>
            <numerusform>%1: %n photos, without depth.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewPresenter</name>
    <message numerus="yes">
        <source>Saving %n frame(s)</source>
        <translation>
            <numerusform>Saving %n frame</numerusform>
            <numerusform>Saving %n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n frame(s) to %1.</source>
        <translation>
            <numerusform>Wrote %n frame to %1.</numerusform>
            <numerusform>Wrote %n frames to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RailPanel</name>
    <message numerus="yes">
        <source>The program laid the rest around %n locked rail(s).</source>
        <translation>
            <numerusform>The program laid the rest around %n locked rail.</numerusform>
            <numerusform>The program laid the rest around %n locked rails.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Laid by hand; %n of them locked.</source>
        <translation>
            <numerusform>Laid by hand; %n of them is locked.</numerusform>
            <numerusform>Laid by hand; %n of them are locked.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rail %1: %n stop(s), %L2 m, heading %3°</source>
        <translation>
            <numerusform>Rail %1: %n stop, %L2 m, heading %3°</numerusform>
            <numerusform>Rail %1: %n stops, %L2 m, heading %3°</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewMode</name>
    <message numerus="yes">
        <source>&amp;Check %n photo(s)</source>
        <translation>
            <numerusform>&amp;Check %n photo</numerusform>
            <numerusform>&amp;Check %n photos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewModel</name>
    <message numerus="yes">
        <source>%n private region(s), which exports show blurred</source>
        <translation>
            <numerusform>%n private region, which exports show blurred</numerusform>
            <numerusform>%n private regions, which exports show blurred</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewPresenter</name>
    <message numerus="yes">
        <source>%n photo(s) checked: %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>%n photo checked: %1 good, %2 doubtful, %3 failed.</numerusform>
            <numerusform>%n photos checked: %1 good, %2 doubtful, %3 failed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) searched</source>
        <translation>
            <numerusform>%n photo searched</numerusform>
            <numerusform>%n photos searched</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) found</source>
        <translation>
            <numerusform>%n face found</numerusform>
            <numerusform>%n faces found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>in %n photo</numerusform>
            <numerusform>in %n photos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StationQueue</name>
    <message numerus="yes">
        <source>%n photo(s) found their place. Walk on about half a metre.</source>
        <translation>
            <numerusform>%n photo found its place. Walk on about half a metre.</numerusform>
            <numerusform>%n photos found their place. Walk on about half a metre.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StoryWords</name>
    <message numerus="yes">
        <source>The checks found %n thing(s).</source>
        <translation>
            <numerusform>The checks found %n thing.</numerusform>
            <numerusform>The checks found %n things.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The station has %n other photo(s).</source>
        <translation>
            <numerusform>The station has %n other photo.</numerusform>
            <numerusform>The station has %n other photos.</numerusform>
        </translation>
    </message>
</context>
</TS>
