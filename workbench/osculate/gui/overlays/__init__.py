"""What Osculate draws in the 3D view: small builders of Coin nodes."""
