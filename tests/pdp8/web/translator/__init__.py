"""The translator, against Python itself."""
