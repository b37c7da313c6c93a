"""For teachers: exercises, and the answers of a class marked against them.

exercise   an exercise as data;           form      its file, in TOML;   tables its keys and values
draw       its random cases
student    the form that students get
answer     a student's answer;            handed    the file it is in, read within bounds
trial      an answer run on one trial: what it punched, printed and left in core
marking    points and failures of an answer;        values   a sheet's answers
diagnosis  what happened in one trial;    evidence  what all of them show;   hints  the hint that follows
where      the place where an answer goes wrong;    link     that opens the workbench there
bounded    a class marked, each answer within bounds of time and memory, in a process of its own
proof      that an exercise is a contract: what it looks at is told;   mutants   slips of a solution
scores     marks as a table for people;   records   as CSV, JSON and JUnit;      page   a page for a student
alike      which answers look alike
course     the bundled exercises in the order of a class
cards      cards to print                 drill     drills at the panel, and their coach
minute    the first minute at the panel, guided
exercises/ the bundled ones, and the functions that draw for them

exercise, answer, trial, marking, where, diagnosis, evidence, hints and values are in the subset that pages
translate.
"""
