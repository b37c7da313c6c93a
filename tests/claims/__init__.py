"""The register of claims: register.py is its loader, claims.txt has it."""
