// Made by `python -m pdp8.web.facts` from the Python tables. Change those.

export const TIMES = {"SECOND": 20000000, "CYCLE": 32, "IO_TICKS": 53, "IOP1": -3, "IOP2": 15, "IOP4": 33, "IOP2_TO_IOP4": 18, "FRAME": 2000000, "START_CHECKED": 90909, "RECEIVED": 1545455, "READ": 66667, "PUNCH": 400000};
export const ISA = {"AND": 0, "TAD": 1, "ISZ": 2, "DCA": 3, "JMS": 4, "IOT": 6, "OPR": 7, "GROUP_2": 256, "GROUP_3": 257, "CLA": 128, "CLL": 64, "CMA": 32, "CML": 16, "RAR": 8, "RAL": 4, "TWICE": 2, "IAC": 1, "SMA": 64, "SZA": 32, "SNL": 16, "REVERSED": 8, "OSR": 4, "HLT": 2, "FETCH": 0, "DEFER": 1, "EXECUTE": 2, "JMP": 5, "ADDRESS": 127, "PAGE": 3968, "CURRENT_PAGE": 128, "INDIRECT": 256};
export const OPERATIONS = ["AND", "TAD", "ISZ", "DCA", "JMS", "JMP", "IOT", "OPR"];
export const STATES = ["FETCH", "DEFER", "EXECUTE"];
export const INTERRUPT = 3;
export const PROTECTED = 3968;
export const LOADERS = {"RIM": [3098, 3097, 2799, 3102, 3654, 3590, 3912, 2799, 3590, 3097, 2807, 3100, 3856, 2046, 1790, 2798, 0], "RIM_START": 4078, "BIN_START": 4095, "BIN_HALT": 4032, "TELETYPE_READER": 4095};
export const ASCII = {"BELL": 7, "LF": 10, "CR": 13, "space": 32, "RUBOUT": 127};
export const LEADER = 128;
export const EIA = {"32": "0", "1": "1", "2": "2", "19": "3", "4": "4", "21": "5", "22": "6", "7": "7", "8": "8", "25": "9", "97": "A", "98": "B", "115": "C", "100": "D", "117": "E", "118": "F", "103": "G", "104": "H", "121": "I", "81": "J", "82": "K", "67": "L", "84": "M", "69": "N", "70": "O", "87": "P", "88": "Q", "73": "R", "50": "S", "35": "T", "52": "U", "37": "V", "38": "W", "55": "X", "56": "Y", "41": "Z", "16": " ", "49": "/", "107": ".", "59": ",", "112": "+", "64": "-", "14": "&", "26": "(", "74": ")", "128": "\n", "62": "\t", "42": "\b", "11": "%", "124": "\u000e", "122": "\u000f"};
export const END_OF_BLOCK = 128;
export const FIELDS = {"sequence": 3, "preparatory": 1, "x": 5, "y": 5, "reserved": 1, "tool": 2, "miscellaneous": 2};
export const ROWS = 20;
