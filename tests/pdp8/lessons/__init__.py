"""Tests of the lessons: exercises, marks, and what hostile answers can do."""
