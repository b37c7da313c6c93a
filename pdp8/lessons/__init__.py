"""A teacher's room: exercises, and the answers of a class marked against them.

exercise   an exercise's file: the task, the cases or questions, the solution, the usual mistakes
answer     a student's file, whatever is in it, read within bounds
trial      an answer run on one case: what it punched, printed and left in core
marking    points and failures of an answer;   proof   that an exercise tells its mistakes from its solution
scores     marks as a table for people;   records   the same as JSON and JUnit
cards      cards to print             drill      drills at the panel, and their coach
exercises/ the bundled ones
"""
