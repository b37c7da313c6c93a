"""The tests mirror the packages; test_chain is the main job, test_arrows the house, test_readme its door."""
