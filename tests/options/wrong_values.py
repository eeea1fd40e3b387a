"""Wrong values for every option that takes a text. $FOLDER, $FILE, $NONE: a folder, a file of nonsense, and neither."""

SIZES = ["40", "x30", "0x30", "-4x3", "4.5x3", "4x3x2", "nanxnan", "99999x3"]
KEYS = ["$NONE", "$FOLDER", "$FILE"]
ENDPOINTS = ["5770", "http://127.0.0.1:5770", "tcp://127.0.0.1:99999", "tcp://127.0.0.1:-1"]
FILES = ["$NONE/a.csv", "$FOLDER", "$FILE"]
NEW_FOLDERS = ["$FILE", "$FILE/new"]
NAMES = ["nosuch"]
LENSES = ["nosuch:1,2,3,4", "radtan:1", "radtan:a,b,c,d", "radtan:nan,0,0,0", "radtan"]
METHODS = ["nosuch", "svgf:nosuch=1", "svgf:alpha=x", "svgf:alpha=nan"]
SETTINGS = ["svgf", "nosuch@2", "svgf@0", "event_svgf@3", "svgf@x"]
RANGES = ["x", "5:1", "0:3", "1:2:3", "-1:2", "1:1e9"]

TEXTS = {
    # of saccaded
    "--data": ENDPOINTS, "--broadcast": ENDPOINTS, "--http": ["5773", "tcp://127.0.0.1:5773", "http://127.0.0.1:99999"],
    "--viewer": NAMES, "--viewer-key": KEYS, "--client-keys": KEYS, "--instructions": NAMES,
    "--scenes": ["$NONE", "$FILE"], "--meshes": ["$NONE", "$FILE", "$FOLDER:$NONE"], "--bakes": NEW_FOLDERS,
    "--accuracy": KEYS, "--simplification": KEYS, "--log-level": NAMES, "--log-format": NAMES, "--config": KEYS,
    # of saccade
    "--control": ENDPOINTS, "--secret-key": KEYS, "--server-key": KEYS, "scene": NAMES, "--output": ["a.xyz", *FILES[:2]],
    "--format": ["nosuch", "evt3"], "--preview": ["a.jpg", "$NONE/a.png"], "--truth": ["nosuch", "depth:0", "depth:-1",
                                                                                       "depth:x", ":3"],
    "--model": NAMES, "--start-level": NAMES, "--reconstruction": NAMES, "--preset": NAMES, "--delivery": NAMES, "--clock": NAMES,
    "--codec": NAMES, "--topic": NAMES, "--method": NAMES, "--animation": NAMES, "--disable": NAMES, "--transfer": NAMES, "--size": SIZES,
    "--columns": ["nosuch", "t,x,y", "t,x,y,y", "t,,y,p"], "--unit": ["min", "S", "1"],
    "--noise": ["leak_hz", "leak_hz=much", "leak_hz=-1", "leak_hz=nan", "nosuch=1"],
    "--trajectory": ["nosuch", "pan", "pan:fast", "pan:nan", "pan:1e300", "fly:1", "$NONE.csv", "$FILE"],
    "--object": ["tall_block", "=spin:90", "tall_block=", "tall_block=spin", "tall_block=spin:fast", "tall_block=spin:nan",
                 "tall_block=spin:1e300", "tall_block=fly:1", "nosuch=spin:9", "tall_block=$NONE.csv", "tall_block=$FILE"],
    "--trajectory-format": NAMES, "--further-view": ["1,2", "a,b,c", "nan,0,0", "1,2,3,0,0,0,0"],
    "--calibration": ["$NONE.yaml", "$FILE"], "--body-camera": ["1,2", "a,b,c", "nan,0,0"], "--up": NAMES,
    "--imu": ["nosuch=1", "rate_hz", "rate_hz=much", "$NONE.yaml"], "--gravity": ["1,2", "a,b,c"],
    "--start": ["1,2,3", "1,2", "a,b,c"], "--intrinsics": ["1", "a,b,c,d", "nan,1,1,1", "0,1,1,1"],
    "--distortion": LENSES, "--set": ["alpha", "alpha=x", "nosuch=1", "max_history=nan"],
    "--max-event-change": ["2", "0%", "x%", "nan%", "-1%", "200%"],
    "--listen": ["nosuch", "127.0.0.1", "127.0.0.1:99999", "127.0.0.1:x"], "frames": ["$NONE", "$FOLDER"],
    "recording": KEYS, "input": ["$NONE.csv", "$FILE", "$FOLDER"], "output": ["a.xyz", *FILES[:2]],
    "file": ["$NONE.csv", "$FILE", "$FOLDER"], "name": ["$NONE/name"],
    "A": ["$NONE.csv", "$FILE", "$FOLDER"], "B": ["$NONE.csv", "$FILE", "$FOLDER"],
    # of saccade-eval
    "scenes": NAMES, "dump": ["$NONE", "$FILE"], "reference": ["$NONE", "$FILE"], "picture": ["$NONE", "$FOLDER", "$FILE"],
    "--dump": NEW_FOLDERS, "--cache": NEW_FOLDERS, "--frames": RANGES, "--methods": METHODS, "--metrics": NAMES,
    "--within": ["20", "ms", "x%", "nan%", "-1ms"], "--candidates": SETTINGS, "--baselines": SETTINGS, "--motions": NAMES,
    "--tolerance": ["2", "0%", "nan%", "200%"], "--curves": NAMES, "--tasks": NAMES,
    "--leave-out": ["1,2", "1,2,3", "a,b,cxd", "0,0,0x0"],
}
NUMBERS = {"FLOAT": ["five", "nan", "inf", "-1e300", "5px"], "INT": ["five", "nan", "2.5", "-1e300", "5px"],
           "UINT": ["five", "-1", "2.5", "99999999999999999999"]}

# None of these may be in an answer: they are of no help to a user.
WORDS_OF_OTHERS = ["INTERNAL", "INVALID_ARGUMENT", "std::", "basic_", "terminate", "what()", "protobuf", "google",
                   "filesystem error", "Assertion", "check failed", "bad_alloc", "stoi", "stod"]


def wrong_values(option):
    """Raises KeyError for an option that is new."""
    if option.name == "--output" and "folder for" in option.about:
        return [*NEW_FOLDERS, ""]
    if option.name == "--output" and "rows of other scenes" in option.about:
        return ["$FOLDER", ""]
    return [*(NUMBERS[option.kind] if option.kind in NUMBERS else TEXTS[option.name]), ""]
