"""The tests mirror the packages; test_chain is the main job, test_arrows the imports, test_readme the examples."""
